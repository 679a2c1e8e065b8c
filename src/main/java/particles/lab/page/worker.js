
// Runs in a worker, after the compiled classes: makes steps while the page wants them, and tells what there is to see.
const SLICE = 25;                       // milliseconds of steps between two messages, at most
let playing = false, ticking = false, speed = 1, target = 0, lastTick = 0, catchUp = null, pull = null;
let knownStructure = null, file = null, plotted = -1, chosen = null;

function tell(more) {
  const message = {type: 'frame', ...JSON.parse(status()), ...more};
  message.state = state().slice();
  message.energies = energies(plotted).slice();                 // after the steps since the last message
  message.points = chosen ? phase(chosen.id, chosen.axis, plotted).slice() : new Float32Array();
  plotted = Math.max(plotted, message.reached);
  if (structureNumber() !== knownStructure) {
    knownStructure = structureNumber();
    message.structure = JSON.parse(structure());
  }
  postMessage(message, [message.state.buffer, message.energies.buffer, message.points.buffer]);
  return message;
}

/** An error that nobody expected is told in the program's own words; what is asked next is done as ever. */
function guarded(work) {
  return message => {
    try {
      work(message);
    } catch (error) {
      playing = false;
      postMessage({type: 'broken', message: error.message || String(error)});
    }
  };
}

function open(message) {
  playing = false;
  const facts = JSON.parse(openScene(message.file, message.text, message.solver, message.deltaT, message.tolerance));
  if (!facts.errors) {
    file = message;
    knownStructure = null;
    target = 0;
    plotted = -1;
    catchUp = pull = null;
  }
  postMessage({type: 'opened', run: message.run, facts});
  if (!facts.errors) {
    tell();
  }
  return !facts.errors;
}

function tick() {
  ticking = false;
  if (!playing) {
    return;
  }
  const now = performance.now();
  target = catchUp ?? target + speed * (now - lastTick) / 1000;
  lastTick = now;
  advance(target, SLICE);
  const {time, over, failure} = tell();
  if (catchUp !== null && time >= catchUp) {
    catchUp = null;
    dragged();
  }
  target = Math.min(target, time + speed * SLICE / 1000);       // what is too slow for real time does not run after it
  if (over || failure) {
    playing = false;
    return;
  }
  later(now);
}

/** Hands the latest pull to the run; while it catches up with the moment it goes on from, the pull waits. */
function dragged() {
  if (pull && catchUp === null) {
    drag(pull.id, ...pull.point);
  }
}

function later(started) {
  if (!ticking) {
    ticking = true;
    setTimeout(guarded(tick), Math.max(0, 16 - (performance.now() - started)));
  }
}

function play() {
  playing = true;
  lastTick = performance.now();
  later(lastTick - 16);
}

const commands = {
  solvers: () => postMessage({type: 'solvers', solvers: JSON.parse(solvers())}),
  open,
  play: message => { speed = message.speed; play(); },
  pause: () => { playing = false; },
  step: () => {
    step();
    const {time, reached} = JSON.parse(status());
    target = reached;
    tell({looking: time < reached});
  },
  look: message => { playing = false; look(message.time); tell({looking: true}); },
  // What comes after a moment seen long ago is computed anew from the start.
  goOn: message => { if (open(file)) { speed = message.speed; catchUp = message.time; play(); } },
  run: message => { advance(Infinity, message.milliseconds); postMessage({type: 'ran', ...JSON.parse(status())}); },
  phase: message => {
    chosen = message;
    postMessage({...message, points: phase(message.id, message.axis, -1).slice()});
  },
  particle: ({id}) => postMessage({type: 'particle', id, ...JSON.parse(particle(id))}),
  drag: message => { pull = message; dragged(); },
  state: message => {
    advance(message.time, 1e9);
    postMessage({type: 'state', ...JSON.parse(status()), state: exactState()});
  }
};
const handle = guarded(message => commands[message.type](message));
onmessage = event => handle(event.data);
