
// Runs in a worker, after the compiled classes: makes steps while the page wants them, and tells what there is to see.
const engine = session();               // the lab's Session, or what was recorded of one
const SLICE = 25;                       // milliseconds of steps between two messages, at most
const ENDING = 4000, LAST_STEPS = 30;   // milliseconds that the last steps of a run that fails are shown for
let playing = false, ticking = false, speed = 1, target = 0, lastTick = 0, catchUp = null, stops = false, pull = null;
let followed = 0;                       // the moment of another run that this one has gone to
let ending = null;                      // how the last steps of a run that has failed are shown
let trails = false;
let knownStructure = null, file = null, plotted = -1, chosen = null;

function tell(more) {
  const message = {type: 'frame', ...JSON.parse(engine.status()), ...more};
  message.state = engine.state().slice();
  message.energies = engine.energies(plotted).slice();          // after the steps since the last message
  message.path = trails ? engine.states(plotted).slice() : new Float32Array();
  message.points = columns(plotted);
  plotted = Math.max(plotted, message.reached);
  if (engine.structureNumber() !== knownStructure) {
    knownStructure = engine.structureNumber();
    message.structure = {ids: JSON.parse(engine.ids()), numbers: engine.structure().slice()};
  }
  postMessage(message, [message.state, message.energies, message.path].map(({buffer}) => buffer));
  return message;
}

/** The times and the chosen quantities after each step later than a time, and last at the moment shown. */
const columns = time => !chosen ? [] : [{what: -1}, ...chosen.quantities].map(({what, id = '', other = ''}) =>
    engine.values(what, id, other, time).slice());

/** An error that nobody expected is told in the program's own words; what is asked next is done as ever. */
function guarded(work) {
  return message => {
    try {
      work(message);
    } catch (error) {
      playing = false;
      postMessage({type: 'broken', message: error.message || String(error), asked: message});
    }
  };
}

/** Puts a scene at its start, unless it has errors. */
function start(message) {
  playing = false;
  const facts = JSON.parse(engine.open(message.file, message.text, message.solver, message.deltaT, message.tolerance,
      message.set));
  if (!facts.errors) {
    file = message;
    knownStructure = null;
    target = 0;
    plotted = -1;
    catchUp = pull = ending = null;
    trails = [facts.look, ...Object.values(facts.look.marks)].some(({trail}) => trail > 0);
    engine.setEndless(Boolean(message.endless));
    stops = false;
    followed = 0;
  }
  return facts;
}

function tick() {
  ticking = false;
  if (!playing) {
    return;
  }
  const now = performance.now();
  if (ending) {
    end(now);
    return;
  }
  target = catchUp ?? target + speed * (now - lastTick) / 1000;
  lastTick = now;
  engine.advance(target, SLICE);
  const {reached, failure} = JSON.parse(engine.status());
  if (failure) {
    const times = engine.values(-1, '', '', -1);         // and that of the moment shown
    ending = {began: now, from: times[Math.max(0, times.length - 2 - LAST_STEPS)], to: reached};
    end(now);
    return;
  }
  const {time, over} = tell();
  if (catchUp !== null && time >= catchUp) {
    catchUp = null;
    dragged();
  }
  target = Math.min(target, time + speed * SLICE / 1000);       // what is too slow for real time does not run after it
  if (over || catchUp === null && stops) {
    playing = stops = false;
    return;
  }
  later(now);
}

/** Shows the last steps of a run that has failed, so slowly that an eye can follow; then says why it has failed. */
function end(now) {
  const part = (now - ending.began) / ENDING;
  engine.between(ending.from + Math.min(1, part) * (ending.to - ending.from));
  if (part < 1) {
    tell({over: false, failure: '', looking: true, slowed: true});
    later(now);
  } else {
    playing = stops = false;
    tell();
  }
}

/** Hands the latest pull to the run; while it catches up with the moment it goes on from, the pull waits. */
function dragged() {
  if (pull && catchUp === null) {
    engine.drag(pull.id, ...pull.point);
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

/**
 * The energies, places and velocities after each step that was kept, as text; a particle has empty cells before its
 * birth and after its death. The moment shown stays.
 */
function tableOfRun(names) {
  const rows = engine.energies(-1).slice(), width = 1 + names.length, shown = JSON.parse(engine.status()).time;
  const moments = [], columns = new Map();
  let present = null, known = null;
  for (let r = 0; r < rows.length; r += width) {
    engine.look(rows[r] + 1e-7 * Math.abs(rows[r]));    // its time is rounded to 7 digits
    if (engine.structureNumber() !== known) {
      known = engine.structureNumber();
      present = JSON.parse(engine.ids());
      present.forEach(id => columns.has(id) || columns.set(id, columns.size));
    }
    moments.push({time: JSON.parse(engine.status()).time, energies: rows.subarray(r + 1, r + width), ids: present,
      state: engine.state().slice()});
  }
  engine.look(shown);
  const ofParticle = id => [' (m)', ' (m/s)'].flatMap(
      (unit, k) => [...'xyz'].map(axis => ['', 'v'][k] + axis + ' of ' + id + unit));
  const head = ['time (s)', ...names.map(name => name + ' (J)'), ...[...columns.keys()].flatMap(ofParticle)]
      .map(name => /[",]/.test(name) ? '"' + name.replace(/"/g, '""') + '"' : name).join();
  return new Blob([head + '\n', ...moments.map(({time, energies, ids, state}) => {
    const cells = Array(6 * columns.size).fill('');
    ids.forEach((id, i) => cells.splice(6 * columns.get(id), 6, ...state.subarray(6 * i, 6 * i + 6)));
    return [time, ...energies, ...cells].map(one => one === '' ? '' : Number(one.toPrecision(8))).join() + '\n';
  })], {type: 'text/csv'});
}

const commands = {
  open: message => {
    const facts = start(message);
    if (message.known) {                // the page was written with the answer
      plotted = 0;
      knownStructure = engine.structureNumber();
      return;
    }
    postMessage({type: 'opened', run: message.run, facts});
    if (!facts.errors) {
      tell();
    }
  },
  play: message => { speed = message.speed; stops = false; play(); },
  endless: ({endless}) => { file.endless = endless; engine.setEndless(endless); },
  pause: () => { playing = false; postMessage({type: 'paused'}); },
  step: () => {
    engine.step();
    const {time, reached} = JSON.parse(engine.status());
    target = reached;
    tell({looking: time < reached});
  },
  look: message => { playing = false; engine.look(message.time); tell({looking: true}); },
  // What comes after a moment seen long ago is computed anew from the start.
  goOn: message => { start(file); speed = message.speed; catchUp = message.time; play(); },
  // Another run's moment.
  follow: ({time}) => {
    if (time === followed) {
      return;
    }
    followed = time;
    if (time < JSON.parse(engine.status()).reached) {
      playing = stops = false;
      engine.look(time);
      tell({looking: true});
    } else if (!ending) {
      commands.reach({time});
    }
  },
  reach: message => { catchUp = message.time; stops = true; play(); },
  run: message => {
    engine.advance(Infinity, message.milliseconds);
    postMessage({type: 'ran', ...JSON.parse(engine.status())});
  },
  phase: message => {
    chosen = message;
    postMessage({...message, points: columns(-1)});
  },
  edit: ({text, how, what}) => postMessage({type: 'edited',
    text: {place, join, toggleFixed, remove}[how](text, ...what)}),
  table: ({energies}) => postMessage({type: 'table', table: tableOfRun(energies)}),
  particle: ({id}) => postMessage({type: 'particle', id, ...JSON.parse(engine.particle(id))}),
  region: message => postMessage({...message, values: engine.region(message.solver, message.left, message.bottom,
      message.cell, message.columns, message.rows).slice()}),
  drag: message => { pull = message; dragged(); },
  // The state at a time, also between two steps.
  sample: ({time}) => {
    engine.advance(time, 1e9);
    const {failure} = JSON.parse(engine.status());
    postMessage({type: 'sample', time, failure, ids: engine.ids(), state: engine.state().slice(),
      lastStep: engine.exactState()});
  }
};
const WITHOUT_SCENE = ['open', 'region'];
const handle = guarded(message => commands[message.type](message));
onmessage = ({data}) => {
  if (file || WITHOUT_SCENE.includes(data.type)) {      // until a scene is open, all other messages are ignored
    handle(data);
  }
};
