// Ties the page together: what is chosen goes to the worker that runs the compiled classes, what it tells is shown.
import {Address} from './address.js';
import {$, few, make} from './dom.js';
import {Gallery} from './gallery.js';
import {listen, toggleFullScreen} from './keys.js';
import {save, unpack} from './packing.js';
import {makeView} from './view.js';
import {ComparisonPlot, EnergyPlot, PhasePlot} from './plots.js';
import {COLOURS, Panels, captionOf} from './panels.js';
import {Editor} from './editor.js';
import {Hand} from './hand.js';
import {Inspector} from './inspector.js';
import {Parameters} from './parameters.js';
import {Film, Rates, composed, plotImage, savePicture} from './saving.js';
import {Settings} from './settings.js';
import {Stability} from './stability.js';
import {Table} from './tables.js';
import {ofPage} from './words.js';

const REFERENCE_PARTICLES = 40, REFERENCE_MILLISECONDS = 4000;
const WITHOUT_PULLS = 'The run up to this moment was computed anew, without your earlier pulls.';
const PLOT_INTERVAL = 80;              // milliseconds: a curve of 4000 points takes 20 to draw

const STILL = matchMedia('(prefers-reduced-motion: reduce)');
const engine = URL.createObjectURL(new Blob([await unpack($('engine').textContent)], {type: 'text/javascript'}));
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
const parameters = new Parameters(editor);
const stability = new Stability(engine), settings = new Settings(change, stability);
const panels = new Panels(engine, panelsChanged, heard), comparison = new ComparisonPlot($('comparison'));
const tables = [new Table($('energyTable'), () => energy.table()), new Table($('phaseTable'), () => phase.table())];
const film = new Film($('view'), note), rates = new Rates();
const address = new Address(describe, openState, note);

function note(text) {
  $('note').textContent = text;
}

// ---- opening scenes ----

const scenes = [...document.querySelectorAll('script.scene')];
const textOf = name => scenes.find(scene => scene.dataset.name === name)?.textContent;
new Gallery(scenes, name => { note(''); choose(name); });

function choose(name, solver = '') {
  openText(textOf(name), {solver});
}

/** Opens a scene with new settings; it moves at once unless the system asks for reduced motion. */
function openText(newText, settings = {}) {
  editor.text = text = newText;
  wanted = null;
  parameters.forget();
  $('particle').replaceChildren();
  chosen = {solver: '', deltaT: '', tolerance: 0, ...settings};
  open(!STILL.matches);
}

// ---- what a link holds ----

/** The state of the page; what is as in the page's own scene is left out. */
function describe() {
  const scene = $('scene').value;
  return {scene, ...(text !== textOf(scene) && {text}), ...chosen, time: playing ? 0 : frame?.time,
    panels: panels.describe(), equalWork: $('equalWork').checked, camera: view.camera?.describe(),
    particle: $('particle').value, axis: $('axis').value};
}

/** Goes to a state that this or another page has described. */
function openState(state) {
  const own = textOf(state.scene);
  if (typeof (state.text ?? own) !== 'string') {
    throw new Error('no scene');
  }
  $('scene').value = own === undefined ? $('scene').value : state.scene;
  $('equalWork').checked = Boolean(state.equalWork);
  panels.set((state.panels ?? []).map(({solver, deltaT}) => ({solver: String(solver), deltaT: String(deltaT)})));
  openText(state.text ?? own, {solver: String(state.solver ?? ''), deltaT: String(state.deltaT ?? ''),
    tolerance: Number(state.tolerance) || 0});
  wanted = state;
  autoplay &&= !(state.time > 0);
}

/** What was chosen beside the scene's text; what the text says of it later goes before it again. */
let chosen = {solver: '', deltaT: '', tolerance: 0};
let text = '', good = null;             // good: the settings of the scene that runs
let wanted = null;                      // the state that is being opened

const sent = () => ({file: $('scene').value, text, ...chosen});

function change(more) {
  note('');
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
function open(play = playing) {
  autoplay = play;
  pulled = false;
  setPlaying(false);
  worker.postMessage({type: 'open', run: ++run, ...sent()});
  address.changed();
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
  parameters.show(facts.numbers);
  inspector.start();
  startPlots();
  $('time').max = facts.duration;
  if (wanted?.time > 0) {
    worker.postMessage({type: 'reach', time: Number(wanted.time)});
  }
  if (autoplay) {
    start();
  }
}

// ---- running ----

function setPlaying(on) {
  playing = on;
  if (!on && structure) {
    tables.forEach(table => table.draw(Infinity));
    askForPhase();                      // all steps, also those between the moments shown
    address.changed();
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
    startPlots();
    newPhase();
  }
}

function pause() {
  autoplay = false;
  worker.postMessage({type: 'pause'});
  setPlaying(false);
}

function shown(message) {
  if (message.structure) {
    structure = message.structure;
    const first = frame === null || view.facts !== facts;
    if (first) {
      view.open(facts, structure, message.state);
      view.camera?.restore(wanted?.camera);
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
  comparison.add(0, message.energies, 1 + facts.energies.length);
  panels.tell({type: 'follow', time: message.time});
  $('time').value = message.time;
  const particle = structure.ids.indexOf($('particle').value);
  if (particle >= 0) {
    const at = 6 * particle + Number($('axis').value);
    phase.mark(message.state[at], message.state[at + 3]);
    inspector.show($('particle').value, message.state, particle, looking);
  }
  $('firstCaption').textContent = panels.all.length ? captionOf(facts, message) : '';
  $('clock').textContent = few(message.time) + ' s';
  $('steps').textContent = message.steps;
  $('evaluations').textContent = message.evaluations;
  $('seconds').textContent = few(message.seconds) + ' s';
  $('work').replaceChildren(...Object.entries(message.work).filter(([name, joules]) => joules)
      .map(([name, joules]) => make('li', {textContent: name + ': ' + few(joules)})));
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
  if (structure.ids.includes(wanted?.particle)) {
    $('particle').value = wanted.particle;
    $('axis').value = wanted.axis;
  } else if (!$('particle').value && facts.phase) {
    $('particle').value = facts.phase[0];
    $('axis').value = facts.phase[1];
  }
  wanted = null;
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
  address.changed();
  phase.start('xyz'[$('axis').value], COLOURS.slice(0, panels.all.length));
  if ($('particle').value) {
    askForPhase();
  }
}

const chosenPhase = () => ({type: 'phase', id: $('particle').value, axis: Number($('axis').value)});

function askForPhase() {
  worker.postMessage(chosenPhase());
  reference?.postMessage(chosenPhase());
  panels.tell(chosenPhase());
}

// ---- runs beside the first ----

/** All runs start anew. */
function panelsChanged() {
  $('comparisonSection').hidden = !panels.all.length;
  resize();
  if (facts) {
    open();
    newPhase();
  }
}

function startPlots() {
  energy.start(facts.energies, facts.uniform);
  panels.open(good, facts);
  comparison.start(facts.solver, panels.describe().map(({solver}, i) => ({name: solver, colour: COLOURS[i]})));
}

/** What another run tells. */
function heard(i, message) {
  if (message.type === 'opened' && !message.facts.errors && $('particle').value) {
    panels.all[i].worker.postMessage(chosenPhase());
  } else if (message.type === 'frame') {
    comparison.add(i + 1, message.energies, 1 + facts.energies.length);
    phase.addTo(i, message.points);
  } else if (message.type === 'phase' && isChosen(message)) {
    phase.addTo(i, message.points);
  }
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
  const pull = {type: 'drag', id: point ? id : '', point: point ?? [0, 0, 0]};
  worker.postMessage(pull);
  panels.tell(pull);
}

view.drawn = () => {
  const i = structure?.ids.indexOf($('particle').value) ?? -1;
  inspector.draw(point => view.camera.placeOf(point), i < 0 ? null : [...frame.state.subarray(6 * i, 6 * i + 3)],
      view.camera.viewHeight, $('forces').checked);
  film.drawn();
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
  reference.postMessage(chosenPhase());
}

const isChosen = message => message.id === $('particle').value && message.axis === Number($('axis').value);

// ---- what people do ----

worker.onmessage = ({data}) => ({
  solvers: () => {
    const own = $('students').textContent.split(' ').filter(name => name);
    settings.list(data.solvers, own);
    panels.list(data.solvers, own);
    address.read().then(found => found || openFirst());
  },
  opened: () => opened(data),
  frame: () => shown(data),
  table: () => save(nameOfRun() + '.csv', data.table),
  phase: () => isChosen(data) && phase.set(data.points),
  particle: () => { inspector.answer(data); view.stale = true; },
  broken: () => broken(data.message)
})[data.type]?.();
worker.onerror = event => broken(event.message);

function openFirst() {
  const {name, first} = scenes.find(scene => scene.dataset.first !== undefined).dataset;
  $('scene').value = name;
  choose(name, first);
}

function broken(message) {
  if (frame) {
    frame.failure = message;            // the run cannot go on, only start anew
  }
  setPlaying(false);
  $('message').textContent = 'Internal error; please report it: ' + message;
}

const startOrPause = () => playing ? pause() : start();
const step = () => { pause(); worker.postMessage({type: 'step'}); };
/** Back to the end of the step before. */
const stepBack = () => { setPlaying(false); worker.postMessage({type: 'look', time: frame.time * (1 - 1e-12)}); };
const fullScreen = () => toggleFullScreen(document.querySelector('.picture'));
$('start').onclick = startOrPause;
$('step').onclick = step;
$('restart').onclick = () => open();
$('fullScreen').onclick = fullScreen;
$('fullScreen').hidden = !document.fullscreenEnabled;
$('copyLink').onclick = () => {
  editor.settle();
  address.copy();
};
listen({' ': () => !$('start').disabled && startOrPause(), ArrowRight: () => !$('step').disabled && step(),
  ArrowLeft: () => frame && stepBack(), f: fullScreen});
$('speed').onchange = () => playing && worker.postMessage({type: 'play', speed: Number($('speed').value)});
$('time').oninput = () => { setPlaying(false); worker.postMessage({type: 'look', time: Number($('time').value)}); };
$('particle').onchange = $('axis').onchange = newPhase;
$('arrows').onchange = () => view.setArrows($('arrows').checked);
$('forces').onchange = () => { view.stale = true; };
$('labels').onchange = () => view.setLabels($('labels').checked);
$('logarithmic').onchange = () => energy.setLogarithmic($('logarithmic').checked);
$('showEditor').onclick = () => showEditor($('editor').hidden);
$('save').onclick = () => editor.save($('scene').value);
$('open').onchange = async () => {
  const [file] = $('open').files, content = await file?.text();
  if (file) {
    note('');
    file.name.endsWith('.json') ? address.take(file.name, content) : openText(content);
  }
};

/** Scene and solver, in the names of files. */
const nameOfRun = () => $('scene').value.replace(/\.yaml$/, '') + '-' + facts.solver;
$('savePicture').onclick = () => savePicture(nameOfRun(), composed($('view')));
$('saveEnergy').onclick = () => savePicture(nameOfRun() + '-energy', plotImage($('energy')));
$('savePhase').onclick = () => savePicture(nameOfRun() + '-phase', plotImage($('phase')));
$('saveTable').onclick = () => worker.postMessage({type: 'table', energies: facts.energies});
$('savePicture').disabled = $('film').disabled = !view.camera;          // without WebGL there is none
$('film').onclick = () => film.toggle(nameOfRun());

function showEditor(on) {
  $('editor').hidden = !on;
  $('showEditor').setAttribute('aria-expanded', on);
  document.body.classList.toggle('editing', on);
  editor.refresh();
  resize();
}

const resize = () => [view, energy, phase, comparison, panels, stability].forEach(part => part.resize());
addEventListener('resize', resize);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', resize);

function draw(now = 0) {
  panels.draw(view.camera, $('arrows').checked);
  if (view.draw()) {
    playing ? rates.drew(now, frame.time) : address.changed();          // somebody may have turned the picture
  }
  if (now - plotted > PLOT_INTERVAL) {
    plotted = now;
    [energy, phase, comparison].forEach(plot => plot.draw());
    tables.forEach(table => playing && table.draw(now));
  }
  requestAnimationFrame(draw);
}
new ResizeObserver(resize).observe($('view'));
showEditor(!matchMedia('(max-width: 1699px)').matches);
window.lab = {view, energy, phase, comparison, panels, engine, address};    // for the browser's console and tests
worker.postMessage({type: 'solvers'});
draw();
