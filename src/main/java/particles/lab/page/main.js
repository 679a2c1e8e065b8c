// Ties the page together: what is chosen goes to the worker that runs the compiled classes, what it tells is shown.
import {Address} from './address.js';
import {showBars} from './bars.js';
import {Builder} from './builder.js';
import {$} from './dom.js';
import {showEquations} from './equations.js';
import {Gallery} from './gallery.js';
import {listen} from './keys.js';
import {save} from './packing.js';
import {makeView} from './view.js';
import {DistancePlot, EnergyPlot, PhasePlot} from './plots.js';
import {COLOURS, Panels, captionOf, differs, momentOf} from './panels.js';
import {Editor} from './editor.js';
import {Hand} from './hand.js';
import {Inspector} from './inspector.js';
import {Lecture} from './lecture.js';
import {Nearest} from './nearest.js';
import {FIRST, OPENING} from './opening.js';
import {Parameters} from './parameters.js';
import {PhaseSpace} from './phase.js';
import {Player} from './player.js';
import {Film, Rates, offer} from './saving.js';
import {Settings} from './settings.js';
import {Stability} from './stability.js';
import {columnsOf} from './structure.js';

const PLOT_INTERVAL = 80;              // milliseconds: a curve of 4000 points takes 20 to draw

const STILL = matchMedia('(prefers-reduced-motion: reduce)');
const {engine} = window.started;
let facts = null, structure = null, plotted = 0, barred = null;

const view = makeView($('view'));
const player = new Player(window.started.worker, {paused, renew: () => listenTo(new Worker(engine)),
  restarted: () => { startPlots(); phase.renew(); }});
const hand = new Hand($('view'), view, id => phase.pick(id),
    (id, point) => panels.tell(player.drag(id, point)));
const inspector = new Inspector($('view'), id => player.tell({type: 'particle', id}));
const energy = new EnergyPlot($('energy')), phasePlot = new PhasePlot($('phase'));
const editor = new Editor($('text'), edited);
const parameters = new Parameters(editor);
const stability = new Stability(engine), settings = new Settings(change, stability);
const panels = new Panels(engine, panelsChanged, heard);
const distances = new DistancePlot($('distances'));
const nearest = new Nearest(engine, distances);
const phase = new PhaseSpace(phasePlot, engine, question => { player.tell(question); panels.tell(question); },
    () => panels.all.length, () => { address.changed(); builder.show(); });
const builder = new Builder(view, hand, phase, build, () => open(false), note);
const film = new Film(view, linesOfFilm, note), rates = new Rates();
const lecture = new Lecture(beforeLecture, openState, () => open());
const address = new Address(describe, openState, note);

function note(...parts) {
  $('note').replaceChildren(...parts);
}

// ---- opening scenes ----

const scenes = [...document.querySelectorAll('script.scene')];
/** A scene by its name or its number, as on the command line. */
const nameOf = given => scenes.map(scene => scene.dataset.name)
    .find(name => [given, given + '.yaml'].includes(name) || parseInt(name) === Number(given));
const textOf = name => scenes.find(scene => scene.dataset.name === name)?.textContent;
new Gallery(scenes, name => { note(''); choose(name); });

/** What was chosen beside the scene's text; what the text says of it later goes before it again. */
const AS_IN_TEXT = {solver: '', deltaT: '', tolerance: 0, set: ''};
let chosen = AS_IN_TEXT;
let text = '', good = null;             // good: the settings of the scene that runs
let wanted = null;                      // the state that is being opened
const known = location.hash ? [] : OPENING;            // what the engine would answer to the first that is opened
let edits = 0;                          // whose text is in the editor: 0 is the first run

function choose(name, solver = '') {
  panels.forgetTexts();
  openText(textOf(name), {solver});
}

/** Opens a scene with new settings; it moves at once unless the system asks for reduced motion. */
function openText(newText, settings = {}) {
  text = newText;
  wanted = null;
  showText(0);
  phase.forget();
  builder.turn(false);
  chosen = {...AS_IN_TEXT, ...settings};
  open(!STILL.matches);
}

/** The state of the page; what is as in the page's own scene is left out. */
function describe() {
  const scene = $('scene').value;
  return {scene: scene.replace('.yaml', ''), ...(text !== textOf(scene) && {text}), ...chosen,
    time: player.playing ? 0 : player.frame?.time, panels: panels.describe(), equalWork: Boolean($('equalWork').value),
    camera: view.camera?.describe(), ...phase.describe(), ...(lecture.on && {lecture: lecture.slide})};
}

/** What the page goes back to when a lecture ends. */
function beforeLecture() {
  editor.settle();
  return describe();
}

/** Goes to a state that this or another page has described. */
function openState(state) {
  const name = nameOf(state.scene), own = textOf(name);
  if (typeof (state.text ?? own) !== 'string') {
    throw new Error(state.scene);
  }
  $('scene').value = name ?? $('scene').value;
  $('equalWork').value = state.equalWork ? 'on' : '';
  panels.set(state.panels ?? []);
  openText(state.text ?? own, {solver: String(state.solver ?? ''), deltaT: String(state.deltaT ?? ''),
    tolerance: Number(state.tolerance) || 0, set: String(state.set ?? '')});
  wanted = state;
  lecture.show(Number(state.lecture ?? -1));
  player.autoplay &&= !(state.time > 0);
}

const sent = () => ({file: $('scene').value, text, ...chosen});

function change(more) {
  note('');
  chosen = {...chosen, ...more};
  open();
}

function edited() {
  const before = text;
  if (edits) {
    panels.all[edits - 1].edit(editor.text, text);
    return;
  }
  text = editor.text;
  change({...(differs('solver', before, text) && {solver: '', tolerance: 0}),
    ...(differs('deltaT', before, text) && {deltaT: ''})});
}

/** Changes the first run's text, unless the picture is not of that text. */
function build(how, ...what) {
  showText(0);
  editor.settle();
  structure && good.text === text && player.tell({type: 'edit', text, how, what});
}

/** Starts anew with what is chosen; the run goes on if one was going. An answer that is known is not waited for. */
function open(play) {
  const answer = known.splice(0);
  rates.forget();
  player.open({...sent(), known: answer.length > 0}, play);
  address.changed();
  answer.forEach(data => hear({data}));
}

function opened(message) {
  if (message.run !== player.run) {
    return;
  }
  const errors = message.facts.errors ?? [];
  if (errors.length && good?.text === text && good.solver === chosen.solver
      && (good.deltaT !== chosen.deltaT || good.set !== chosen.set)) {
    chosen = {...chosen, deltaT: good.deltaT, set: good.set};
    settings.refuse(errors);
    player.startIfWanted();
    return;
  }
  if (errors.length && wanted && Object.values(chosen).some(one => one)) {      // the scene without a link's settings
    note(errors.join('; '));
    chosen = AS_IN_TEXT;
    open();
    return;
  }
  $('start').disabled = $('step').disabled = $('restart').disabled = errors.length > 0;
  if (errors.length) {
    showText(0);
    editor.show(errors);
    showEditor(true);
    $('message').textContent = TEXTS.errors(errors.length);
    return;
  }
  good = sent();
  if (message.facts.look.arrows !== facts?.look.arrows) {
    view.setArrows($('arrows').checked = message.facts.look.arrows > 0);
  }
  facts = message.facts;
  structure = null;
  player.opened(facts);
  if (facts.recorded !== undefined) {
    showRecorded();
  }
  $('teaches').textContent = facts.title + ': ' + facts.teaches;
  if (facts.remarks.length) {
    note(facts.remarks.join('; '));
  }
  settings.show(facts, chosen);
  setTimeout(() => message.run === player.run && facts === message.facts      // the picture comes first
    && showNumbers(0, [], facts));
  inspector.start();
  startPlots();
  if (wanted?.time > 0) {
    player.tell({type: 'reach', time: Number(wanted.time)});
  }
  player.startIfWanted();
}

/** A run that was recorded: nothing of it can be changed. */
function showRecorded() {
  document.body.classList.add('recorded');
  hand.dragged = null;
  editor.lock();
  note(TEXTS.recorded(captionOf(facts), facts.recorded));
}

// ---- the text of the first run, or that of one beside it ----

function showText(run) {
  edits = run > panels.all.length ? 0 : run;
  const names = [TEXTS.run(1), ...panels.all.map(panel => panel.name)];
  $('textOf').replaceChildren(...names.map((name, i) => new Option(name, i)));
  $('textOf').value = edits;
  $('textOf').hidden = names.length === 1;
  const its = edits ? panels.all[edits - 1].choice.text ?? text : text;
  if (its !== editor.text) {
    editor.text = its;
    parameters.forget();
  }
}

/** What a run's worker says of its text. */
function showNumbers(run, errors, facts) {
  if (run === edits) {
    editor.show(errors);
    if (facts) {
      parameters.show(facts.numbers);
    }
  }
}

$('textOf').onchange = () => {
  showText(Number($('textOf').value));
  const its = edits ? panels.all[edits - 1].facts : facts;
  its && showNumbers(edits, [], its);
};

// ---- the moments of the first run ----

function paused() {
  if (structure) {
    phase.ask();
    address.changed();
  }
}

function shown(message) {
  const isNew = message.structure && (player.frame === null || view.facts !== facts);
  structure = message.structure ? columnsOf(message.structure) : structure;
  if (!structure) {
    return;
  }
  if (isNew) {
    const camera = hand.builder ? view.camera.pose() : wanted?.camera;
    view.open(facts, structure, message.state);
    view.camera?.restore(camera);
  }
  if (message.structure) {
    view.setStructure(structure);
  }
  view.show(message);
  hand.builder && player.playing && builder.turn(false);
  if (isNew) {
    view.draw();                        // before lists and plots, which take as long again
    phase.start(facts, structure, wanted, good);
    showEquations(facts, structure);
    wanted = null;
    startNearest();
  } else if (message.structure) {
    phase.list(structure);
  }
  energy.add(message.energies);
  phasePlot.add(0, message.points);
  player.show(message);
  panels.tell({type: 'follow', time: message.time});
  phase.reach(message.time);
  const particle = structure.ids.indexOf(phase.id);
  if (particle >= 0) {
    inspector.show(phase.id, message.state, particle, player.looking);
  }
  $('firstCaption').textContent = panels.all.length ? captionOf(facts) + momentOf(message) : '';
}

view.drawn = () => {
  const i = structure?.ids.indexOf(phase.id) ?? -1;
  inspector.draw(point => view.camera.placeOf(point),
      i < 0 ? null : [...player.frame.state.subarray(6 * i, 6 * i + 3)], view.camera.viewHeight, $('forces').checked);
  film.drawn();
};

// ---- runs beside the first ----

/** All runs start anew. */
function panelsChanged() {
  nearest.close();
  showText(edits);
  if (facts) {
    open();
    phase.renew();
  }
}

/** Compares the runs of one scene, once all are opened. */
function startNearest() {
  if (structure && panels.all.every(panel => panel.facts)) {
    nearest.start([{name: TEXTS.named(facts.solver, TEXTS.run(1)), opening: good}, ...panels.all
        .filter(({choice}) => choice.text === undefined).map(({name, index, choice, opening}) =>
        ({name: TEXTS.named(choice.solver, name), colour: COLOURS[index], opening}))], good, facts, structure);
  }
}

function startPlots() {
  energy.start(facts.energies, facts.uniform, facts.duration);
  panels.open(good, facts);
  nearest.close();
}

/** What another run tells. */
function heard(i, message) {
  const panel = panels.all[i];
  if (message.type === 'opened') {
    showNumbers(i + 1, message.facts.errors ?? [], panel.facts);
    if (!message.facts.errors && phase.id) {
      panel.worker.postMessage(phase.question());
    }
    if (!message.facts.errors && structure) {       // it may be opened after the first run's last frame
      panel.worker.postMessage({type: 'follow', time: player.frame.time});
    }
    startNearest();
  } else if (message.type === 'frame' && panel.facts) {
    phasePlot.add(i + 1, message.points);
  } else if (message.type === 'phase') {
    phase.answer(i + 1, message);
  }
}

// ---- what people do ----

const hear = ({data}) => ({
  opened: () => opened(data),
  frame: () => shown(data),
  table: () => save(nameOfRun() + '.csv', data.table),
  phase: () => phase.answer(0, data),
  edited: () => editor.replace(data.text),
  paused: () => { player.waiting = Infinity; },
  particle: () => { inspector.answer(data); view.stale = true; },
  broken: () => player.fail(data.message)
})[data.type]?.();
const listenTo = worker => Object.assign(worker, {onmessage: hear, onerror: event => player.fail(event.message)});
listenTo(player.worker);

function openFirst() {
  $('scene').value = FIRST.name;
  choose(FIRST.name, FIRST.first);
}

const fullScreen = () => document.fullscreenElement ? document.exitFullscreen()
    : (lecture.on ? document.documentElement : $('picture')).requestFullscreen();
$('restart').onclick = () => open();
$('fullScreen').onclick = fullScreen;
$('fullScreen').hidden = !document.fullscreenEnabled;
$('copyLink').onclick = () => {
  editor.settle();
  address.copy();
};
$('undo').onclick = () => editor.undo();
listen({'^z': event => editor.undo(event.shiftKey), ' ': () => player.startOrPause(),
  ArrowRight: () => player.step(), ArrowLeft: () => player.stepBack(), f: fullScreen, l: () => lecture.toggle(),
  PageDown: () => lecture.on && lecture.turn(1), PageUp: () => lecture.on && lecture.turn(-1)});
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
    panels.forgetTexts();
    file.name.endsWith('.json') ? address.take(file.name, () => JSON.parse(content)) : openText(content);
  }
};

/** Scene and solver, in the names of files. */
const nameOfRun = () => $('scene').value.replace(/\.yaml$/, '') + '-' + facts.solver;
/** What is written into pictures and films: also the address or, of a page on a disk, what others can use of it. */
function linesOfFilm() {
  return [facts.title, captionOf(facts) + momentOf(player.frame),
    (location.protocol === 'file:' ? location.hash : location.href).replace(/&?more=.*/, '')];
}

offer(nameOfRun, linesOfFilm, film, energy, phasePlot);
$('saveTable').onclick = () => player.tell({type: 'table', energies: facts.energies});
$('savePicture').disabled = $('film').disabled = $('build').disabled = !view.camera;    // without WebGL

function showEditor(on) {
  $('editor').hidden = !on;
  $('showEditor').setAttribute('aria-expanded', on);
  document.body.classList.toggle('editing', on);
  editor.refresh();
}

const plots = [energy, phasePlot, distances];
const resize = () => [view, ...plots, panels, stability].forEach(part => part.resize());
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', resize);

function draw(now = 0) {
  player.watch(now);
  panels.draw(view.camera, $('arrows').checked);
  if (view.draw()) {
    player.playing ? rates.drew(now, player.frame.time) : address.changed();    // somebody may have turned the picture
  }
  if (now - plotted > PLOT_INTERVAL) {
    plotted = now;
    plots.forEach(plot => plot.draw());
    if (structure && barred !== player.frame) {
      barred = player.frame;
      showBars(energy, barred.time);
    }
  }
  requestAnimationFrame(draw);
}
new ResizeObserver(resize).observe($('view'));
showEditor(!matchMedia('(max-width: 1699px)').matches);
window.lab = {player, view, energy, phase: phasePlot, distances, panels, engine, address};  // for tests
location.hash ? address.read().then(found => found || openFirst()) : openFirst();
draw();
