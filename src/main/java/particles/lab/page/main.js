// Ties the page together: what is chosen goes to the worker that runs the compiled classes, what it tells is shown.
import {makeView} from './view.js';
import {EnergyPlot, PhasePlot} from './plots.js';
import {Editor} from './editor.js';
import {Hand} from './hand.js';
import {Inspector} from './inspector.js';
import {Settings, few} from './settings.js';
import {ofPage} from './words.js';

const $ = id => document.getElementById(id);
const REFERENCE_PARTICLES = 40, REFERENCE_MILLISECONDS = 4000;
const WITHOUT_PULLS = 'The run up to this moment was computed anew, without your earlier pulls.';
const PLOT_INTERVAL = 80;              // milliseconds: a curve of 4000 points takes 20 to draw

const engine = URL.createObjectURL(new Blob([$('engine').textContent], {type: 'text/javascript'}));
const worker = new Worker(engine);
let reference = null;
let facts = null, structure = null, frame = null;
let playing = false, looking = false, run = 0, autoplay = false, plotted = 0, pulled = false;

const view = makeView($('view'));
const hand = new Hand($('view'), view, pick, drag);
const inspector = new Inspector($('view'), id => worker.postMessage({type: 'particle', id}));
const energy = new EnergyPlot($('energy'));
const phase = new PhasePlot($('phase'));
const editor = new Editor($('text'), edited);
const settings = new Settings(change);

// ---- opening scenes ----

const scenes = [...document.querySelectorAll('script.scene')];
$('scene').append(...scenes.map(scene => new Option(scene.dataset.name.replace(/\.yaml$/, ''), scene.dataset.name)));

function choose(name, solver = '') {
  openText(scenes.find(scene => scene.dataset.name === name).textContent, solver);
}

function openText(newText, solver = '') {
  editor.text = text = newText;
  $('particle').replaceChildren();
  change({solver, deltaT: '', tolerance: 0});
}

/** What was chosen beside the scene's text; what the text says of it later goes before it again. */
let chosen = {solver: '', deltaT: '', tolerance: 0};
let text = '', good = null;             // good: the settings of the scene that runs

const sent = () => ({file: $('scene').value, text, ...chosen});

function change(more) {
  chosen = {...chosen, ...more};
  open();
}

function edited() {
  const before = text;
  text = editor.text;
  const differs = key => line(before, key) !== line(text, key);
  change({...(differs('solver') && {solver: '', tolerance: 0}), ...(differs('deltaT') && {deltaT: ''})});
}

const line = (text, key) => RegExp('^' + key + ':.*', 'm').exec(text)?.[0];

/** Starts anew with what is chosen; the run goes on if one was going. */
function open() {
  autoplay = playing;
  pulled = false;
  setPlaying(false);
  worker.postMessage({type: 'open', run: ++run, ...sent()});
}

function opened(message) {
  if (message.run !== run) {
    return;
  }
  const errors = message.facts.errors ?? [];
  if (errors.length && good?.text === text && good.solver === chosen.solver && good.deltaT !== chosen.deltaT) {
    chosen = {...chosen, deltaT: good.deltaT};
    settings.refuse(errors);
    if (autoplay) {
      start();
    }
    return;
  }
  editor.show(errors);
  $('start').disabled = $('step').disabled = $('restart').disabled = errors.length > 0;
  if (errors.length) {
    showEditor(true);
    $('message').textContent = 'The scene has ' + (errors.length === 1 ? 'an error' : errors.length + ' errors')
        + '; see below its text.';
    return;
  }
  good = sent();
  $('message').textContent = '';
  if (message.facts.look.arrows !== facts?.look.arrows) {
    view.setArrows($('arrows').checked = message.facts.look.arrows > 0);
  }
  facts = message.facts;
  structure = null;
  looking = false;
  $('teaches').textContent = facts.title + ': ' + ofPage(facts.teaches);
  settings.show(facts, chosen.tolerance);
  energy.start(facts.energies, facts.uniform);
  inspector.start();
  $('time').max = facts.duration;
  if (autoplay) {
    start();
  }
}

// ---- running ----

function setPlaying(on) {
  playing = on;
  if (!on && structure) {
    askForPhase();                      // all steps, also those between the moments shown
  }
  showStart();
}

function showStart() {
  const again = !frame || frame.failure || frame.over && !looking || !frame.steps;
  $('start').textContent = playing ? 'Pause' : again ? 'Start' : 'Continue';
}

function start() {
  const speed = Number($('speed').value);
  if (frame?.failure || frame?.over && !looking) {
    goOn(0, speed);
  } else if (looking) {
    goOn(frame.time, speed);
  } else {
    worker.postMessage({type: 'play', speed});
  }
  autoplay = false;
  setPlaying(true);
}

/** The worker computes the run anew up to this moment; pulls are not repeated, so what they changed is not kept. */
function goOn(time, speed) {
  $('message').textContent = pulled && time > 0 ? WITHOUT_PULLS : '';
  worker.postMessage({type: 'goOn', run: ++run, time, speed});
  if (pulled) {
    pulled = false;
    energy.start(facts.energies, facts.uniform);
    newPhase();
  }
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
    } else {
      listParticles();
    }
    view.setStructure(structure);
  }
  if (!structure) {
    return;
  }
  frame = message;
  looking = Boolean(message.looking);
  view.show(message);
  energy.add(message.energies);
  phase.add(message.points);
  $('time').value = message.time;
  const particle = structure.ids.indexOf($('particle').value);
  if (particle >= 0) {
    const at = 6 * particle + Number($('axis').value);
    phase.mark(message.state[at], message.state[at + 3]);
    inspector.show($('particle').value, message.state, particle, looking);
  }
  $('clock').textContent = few(message.time) + ' s';
  $('steps').textContent = message.steps;
  $('evaluations').textContent = message.evaluations;
  $('seconds').textContent = few(message.seconds) + ' s';
  $('work').replaceChildren(...Object.entries(message.work).filter(([name, joules]) => joules).map(([name, joules]) => {
    const row = document.createElement('li');
    row.textContent = name + ': ' + few(joules);
    return row;
  }));
  if (message.failure && !looking) {
    $('message').textContent = message.failure;
  }
  if (message.over || message.failure) {
    setPlaying(false);
  }
  showStart();
}

// ---- phase space ----

function startPhase() {
  listParticles();
  if (!$('particle').value && facts.phase) {
    $('particle').value = facts.phase[0];
    $('axis').value = facts.phase[1];
  }
  newPhase();
  startReference();
}

/** The particles that can move; in a scene with births they come and go. */
function listParticles() {
  const before = $('particle').value, first = facts.phase?.[0];
  const ids = structure.ids.filter((id, i) => !structure.fixed[i]);
  if (ids.length && ids.join() !== [...$('particle').options].map(option => option.value).join()) {
    $('particle').replaceChildren(...ids.map(id => new Option(id)));
    $('particle').value = ids.includes(before) ? before : ids.includes(first) ? first : ids[0];
    if (before !== $('particle').value) {
      $('axis').value = $('particle').value === first ? facts.phase[1] : $('axis').value;
      newPhase();
    }
  }
}

function newPhase() {
  phase.start('xyz'[$('axis').value]);
  if ($('particle').value) {
    askForPhase();
  }
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

/** A pull sets a paused run going. */
function drag(id, point) {
  if (point && !playing && !frame?.over) {
    start();
  }
  pulled ||= Boolean(point);
  worker.postMessage({type: 'drag', id: point ? id : '', point: point ?? [0, 0, 0]});
}

view.drawn = () => {
  const i = structure?.ids.indexOf($('particle').value) ?? -1;
  inspector.draw(point => view.camera.placeOf(point), i < 0 ? null : [...frame.state.subarray(6 * i, 6 * i + 3)],
      view.camera.viewHeight, $('forces').checked);
};

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
  reference.postMessage({type: 'open', ...sent(), solver: 'dormand-prince', tolerance: 1e-10,
    deltaT: String(facts.duration / 1000)});
  reference.postMessage({type: 'run', milliseconds: REFERENCE_MILLISECONDS});
  reference.postMessage({type: 'phase', id: $('particle').value, axis: Number($('axis').value)});
}

const isChosen = message => message.id === $('particle').value && message.axis === Number($('axis').value);

// ---- what people do ----

worker.onmessage = ({data}) => ({
  solvers: () => {
    settings.list(data.solvers, $('students').textContent.split(' ').filter(name => name));
    const first = scenes.find(scene => scene.dataset.first !== undefined);
    $('scene').value = first.dataset.name;
    choose(first.dataset.name, first.dataset.first);
  },
  opened: () => opened(data),
  frame: () => shown(data),
  phase: () => isChosen(data) && phase.set(data.points),
  particle: () => { inspector.answer(data); view.stale = true; },
  broken: () => broken(data.message)
})[data.type]?.();
worker.onerror = event => broken(event.message);

function broken(message) {
  if (frame) {
    frame.failure = message;            // the run cannot go on, only start anew
  }
  setPlaying(false);
  $('message').textContent = 'Internal error; please report it: ' + message;
}

$('scene').onchange = () => choose($('scene').value);
$('start').onclick = () => playing ? pause() : start();
$('step').onclick = () => { pause(); worker.postMessage({type: 'step'}); };
$('restart').onclick = open;
$('speed').onchange = () => playing && worker.postMessage({type: 'play', speed: Number($('speed').value)});
$('time').oninput = () => { setPlaying(false); worker.postMessage({type: 'look', time: Number($('time').value)}); };
$('particle').onchange = $('axis').onchange = newPhase;
$('arrows').onchange = () => view.setArrows($('arrows').checked);
$('forces').onchange = () => { view.stale = true; };
$('labels').onchange = () => view.setLabels($('labels').checked);
$('logarithmic').onchange = () => energy.setLogarithmic($('logarithmic').checked);
$('showEditor').onclick = () => showEditor($('editor').hidden);
$('save').onclick = () => editor.save($('scene').value);
$('open').onchange = () => $('open').files[0]?.text().then(text => openText(text));

function showEditor(on) {
  $('editor').hidden = !on;
  $('showEditor').setAttribute('aria-expanded', on);
  document.body.classList.toggle('editing', on);
  editor.refresh();
  resize();
}

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
new ResizeObserver(resize).observe($('view'));
showEditor(!matchMedia('(max-width: 1699px)').matches);
window.lab = {view, energy, phase};          // for the browser's console, and for tests
worker.postMessage({type: 'solvers'});
draw();
