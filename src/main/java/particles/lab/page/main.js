// Ties the page together: what is chosen goes to the worker that runs the compiled classes, what it tells is shown.
import {makeView} from './view.js';
import {EnergyPlot, PhasePlot} from './plots.js';
import {Editor} from './editor.js';

const $ = id => document.getElementById(id);
const few = number => Number(number.toPrecision(4)).toString();
const REFERENCE_PARTICLES = 40, REFERENCE_MILLISECONDS = 4000;
const PLOT_INTERVAL = 80;              // milliseconds: a curve of 4000 points takes 20 to draw

const engine = URL.createObjectURL(new Blob([$('engine').textContent], {type: 'text/javascript'}));
const worker = new Worker(engine);
let reference = null;
let solvers = [], facts = null, structure = null, frame = null;
let playing = false, looking = false, run = 0, autoplay = false, plotted = 0;

const view = makeView($('view'), pick);
const energy = new EnergyPlot($('energy'));
const phase = new PhasePlot($('phase'));
const editor = new Editor($('text'), edited);

// ---- opening scenes ----

const scenes = [...document.querySelectorAll('script.scene')];
$('scene').append(...scenes.map(scene => new Option(scene.dataset.name.replace(/\.yaml$/, ''), scene.dataset.name)));

function choose(name, solver = '') {
  openText(scenes.find(scene => scene.dataset.name === name).textContent, solver);
}

function openText(newText, solver = '') {
  editor.text = text = newText;
  $('particle').replaceChildren();
  change({solver, deltaT: 0, tolerance: 0});
}

/** What was chosen beside the scene's text; what the text says of it later goes before it again. */
let chosen = {solver: '', deltaT: 0, tolerance: 0};
let text = '';

const settings = () => ({file: $('scene').value, text, ...chosen});

function change(more) {
  chosen = {...chosen, ...more};
  open();
}

function edited() {
  const before = text;
  text = editor.text;
  const differs = key => line(before, key) !== line(text, key);
  change({...(differs('solver') && {solver: '', tolerance: 0}), ...(differs('deltaT') && {deltaT: 0})});
}

const line = (text, key) => RegExp('^' + key + ':.*', 'm').exec(text)?.[0];

/** Starts anew with what is chosen; the run goes on if one was going. */
function open() {
  autoplay = playing;
  setPlaying(false);
  worker.postMessage({type: 'open', run: ++run, ...settings()});
}

function opened(message) {
  if (message.run !== run) {
    return;
  }
  const errors = message.facts.errors ?? [];
  editor.show(errors);
  $('start').disabled = $('step').disabled = $('restart').disabled = errors.length > 0;
  if (errors.length) {
    $('message').textContent = 'The scene has ' + (errors.length === 1 ? 'an error' : errors.length + ' errors')
        + '; see below its text.';
    return;
  }
  $('message').textContent = '';
  if (message.facts.look.arrows !== facts?.look.arrows) {
    view.setArrows($('arrows').checked = message.facts.look.arrows > 0);
  }
  facts = message.facts;
  structure = null;
  looking = false;
  $('teaches').textContent = facts.title + ': ' + facts.teaches;
  $('solver').value = facts.solver;
  $('tolerance').value = chosen.tolerance;
  showStep();
  energy.start(facts.energies);
  $('time').max = facts.duration;
  if (autoplay) {
    start();
  }
}

function showStep() {
  const solver = solvers.find(one => one.name === facts.solver);
  const limit = facts.limits[facts.solver];
  const slider = $('deltaT');
  $('sentence').textContent = solver?.sentence ?? 'A solver of your own.';
  $('toleranceLabel').hidden = !solver?.adaptive;
  $('deltaTNumber').value = facts.deltaT;
  slider.value = Math.log10(facts.deltaT);
  slider.setAttribute('aria-valuetext', facts.deltaT + ' seconds');
  const part = limit > 0 ? (Math.log10(limit) - slider.min) / (slider.max - slider.min) : -1;
  $('mark').hidden = !(part >= 0 && part <= 1);
  $('mark').style.left = `calc(${100 * part}% + ${8 - 16 * part}px)`;
  $('limit').textContent = solver?.adaptive ? 'Chooses its own steps, at most deltaT long.'
      : limit === 0 ? 'Undamped springs gain energy at any deltaT.'
      : limit > 0 ? 'Stable at least up to ' + few(limit) + ' s for the springs of this scene (the red mark).'
      : 'No spring limits deltaT here.';
}

// ---- running ----

function setPlaying(on) {
  playing = on;
  if (!on && structure) {
    askForPhase();                      // all steps, also those between the moments shown
  }
  $('start').textContent = on ? 'Pause' : 'Start';
}

function start() {
  const speed = Number($('speed').value);
  if (frame?.failure || frame?.over && !looking) {
    worker.postMessage({type: 'goOn', run: ++run, time: 0, speed});
  } else if (looking) {
    worker.postMessage({type: 'goOn', run: ++run, time: frame.time, speed});
  } else {
    worker.postMessage({type: 'play', speed});
  }
  autoplay = false;
  setPlaying(true);
}

function pause() {
  worker.postMessage({type: 'pause'});
  setPlaying(false);
}

function shown(message) {
  if (message.structure) {
    structure = message.structure;
    const first = frame === null || view.facts !== facts;
    if (first) {
      view.open(facts, structure, message.state);
      startPhase();
    }
    view.setStructure(structure);
  }
  if (!structure) {
    return;
  }
  frame = message;
  looking = Boolean(message.looking);
  view.show(message);
  if (!looking) {
    energy.add(message.time, message.energies);
    $('time').value = message.time;
  }
  const particle = structure.ids.indexOf($('particle').value);
  if (particle >= 0) {
    const at = 6 * particle + Number($('axis').value);
    phase.add(message.state[at], message.state[at + 3], !looking);
  }
  $('clock').textContent = few(message.time) + ' s';
  $('steps').textContent = message.steps;
  $('evaluations').textContent = message.evaluations;
  $('seconds').textContent = few(message.seconds) + ' s';
  if (message.failure && !looking) {
    $('message').textContent = message.failure;
  }
  if (message.over || message.failure) {
    setPlaying(false);
  }
}

// ---- phase space ----

function startPhase() {
  const ids = structure.ids.filter((id, i) => !structure.fixed[i]);
  const before = $('particle').value;
  $('particle').replaceChildren(...ids.map(id => new Option(id)));
  if (ids.includes(before)) {
    $('particle').value = before;
  } else if (facts.phase) {
    $('particle').value = facts.phase[0];
    $('axis').value = facts.phase[1];
  }
  newPhase();
  startReference();
}

function newPhase() {
  phase.start('xyz'[$('axis').value]);
  askForPhase();
}

function askForPhase() {
  const wanted = {type: 'phase', id: $('particle').value, axis: Number($('axis').value)};
  worker.postMessage(wanted);
  reference?.postMessage(wanted);
}

function pick(id) {
  $('particle').value = id;
  newPhase();
}

/** The curve as good as exact, where a scene is small enough that it is known soon. */
function startReference() {
  reference?.terminate();
  reference = null;
  if (structure.ids.length > REFERENCE_PARTICLES) {
    return;
  }
  reference = new Worker(engine);
  reference.onmessage = ({data}) => {
    if (data.type === 'phase' && isChosen(data)) {
      phase.setReference(data.points);
    }
  };
  reference.postMessage({type: 'open', ...settings(), solver: 'dormand-prince', tolerance: 1e-10,
    deltaT: facts.duration / 1000});
  reference.postMessage({type: 'run', milliseconds: REFERENCE_MILLISECONDS});
  reference.postMessage({type: 'phase', id: $('particle').value, axis: Number($('axis').value)});
}

const isChosen = message => message.id === $('particle').value && message.axis === Number($('axis').value);

// ---- what people do ----

worker.onmessage = ({data}) => ({
  solvers: () => {
    solvers = data.solvers;
    const own = $('students').textContent.split(' ').filter(name => name);
    $('solver').append(...[...solvers.map(one => one.name), ...own].map(name => new Option(name)));
    const first = scenes.find(scene => scene.dataset.first !== undefined);
    $('scene').value = first.dataset.name;
    choose(first.dataset.name, first.dataset.first);
  },
  opened: () => opened(data),
  frame: () => shown(data),
  phase: () => isChosen(data) && phase.set(data.points),
  broken: () => broken(data.message)
})[data.type]?.();
worker.onerror = event => broken(event.message);

function broken(message) {
  setPlaying(false);
  $('message').textContent = 'Internal error; please report it: ' + message;
}


$('scene').onchange = () => choose($('scene').value);
$('start').onclick = () => playing ? pause() : start();
$('step').onclick = () => { pause(); worker.postMessage({type: 'step'}); };
$('restart').onclick = open;
$('solver').onchange = () => change({solver: $('solver').value, tolerance: 0});
$('tolerance').onchange = () => change({tolerance: Number($('tolerance').value)});
$('deltaTNumber').onchange = () => change({deltaT: Number($('deltaTNumber').value) || 0});
$('deltaT').oninput = () => { $('deltaTNumber').value = Number((10 ** $('deltaT').value).toPrecision(2)); };
$('deltaT').onchange = () => change({deltaT: Number($('deltaTNumber').value)});
$('speed').onchange = () => playing && worker.postMessage({type: 'play', speed: Number($('speed').value)});
$('time').oninput = () => { setPlaying(false); worker.postMessage({type: 'look', time: Number($('time').value)}); };
$('particle').onchange = $('axis').onchange = newPhase;
$('arrows').onchange = () => view.setArrows($('arrows').checked);
$('labels').onchange = () => view.setLabels($('labels').checked);
$('save').onclick = () => editor.save($('scene').value);
$('open').onchange = () => $('open').files[0]?.text().then(text => openText(text));
const resize = () => [view, energy, phase].forEach(part => part.resize());
addEventListener('resize', resize);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', resize);

function draw(now = 0) {
  view.draw();
  if (now - plotted > PLOT_INTERVAL) {
    plotted = now;
    [energy, phase].forEach(plot => plot.draw());
  }
  requestAnimationFrame(draw);
}
window.lab = {view, energy, phase};          // for the browser's console, and for tests
worker.postMessage({type: 'solvers'});
draw();
