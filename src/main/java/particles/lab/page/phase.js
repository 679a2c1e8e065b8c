// What is plotted over what: quantities of particles, in all runs and in a reference.
import {$} from './dom.js';
import {COLOURS} from './panels.js';

const REFERENCE_PARTICLES = 40, MOST_OTHERS = 60;
const SLICE = 250, AHEAD = 4000;        // milliseconds that the reference runs between answers; before it has to wait

/** What computes a scene as exactly as the page can; null where that would take too long, or nothing can compute. */
export const referenceOf = (sent, facts, structure, tolerance) =>
    structure.ids.length > REFERENCE_PARTICLES || facts.recorded !== undefined ? null
    : {type: 'open', ...sent, solver: 'dormand-prince', tolerance, deltaT: String(facts.duration / 1000)};

export class PhaseSpace {
  /** plot: where the curves are drawn; ask(message): asks all runs; runs(): how many there are beside the first */
  constructor(plot, engine, ask, runs, changed) {
    Object.assign(this, {plot, engine, askRuns: ask, runs, changed, others: [], kept: []});
    $('particle').onchange = $('vertical').onchange = $('horizontal').onchange = () => this.renew();
    $('addCurve').onclick = () => { this.kept.push(this.chosen('vertical')); this.renew(); };
    $('oneCurve').onclick = () => { this.kept = []; this.renew(); };
  }

  get id() {
    return $('particle').value;
  }

  describe() {
    return {particle: this.id, vertical: $('vertical').value, horizontal: $('horizontal').value, curves: this.kept};
  }

  /** What can be plotted: time, what the chosen particle has, energies. */
  quantities() {
    const all = (names, what, unit) => names.map((name, k) => ({what: what + k, unit, label: `${name} (${unit})`}));
    return [...all([TEXTS.time], -1, 's'), ...all(['x', 'y', 'z'], 0, 'm'),
      ...all(['vx', 'vy', 'vz', TEXTS.speedName], 3, 'm/s'), ...all(this.facts.energies, 8, 'J'),
      ...this.others.filter(other => other !== this.id).map(other => ({what: 7, other, unit: 'm',
        label: TEXTS.distanceTo(other) + ' (m)'}))].map(one => ({...one, id: this.id}));
  }

  chosen(select) {
    const all = this.quantities();
    return all.find(({label}) => label === $(select).value) ?? all[0];
  }

  /** Lists what can be plotted; what was chosen stays, if it is still there. */
  offer(wanted) {
    const labels = this.quantities().map(({label}) => label);
    for (const [select, label] of Object.entries(wanted)) {
      $(select).replaceChildren(...labels.map(one => new Option(one)));
      $(select).value = labels.includes(label) ? label : labels[select === 'vertical' ? 4 : 1];
    }
  }

  isChosen({quantities}) {
    return JSON.stringify(quantities) === JSON.stringify(this.question().quantities);
  }

  /** A new scene. wanted: what a link wants to see, or null; sent: what the scene was opened with */
  start(facts, structure, wanted, sent) {
    Object.assign(this, {facts, kept: wanted?.curves ?? []});
    this.list(structure);
    if (structure.ids.includes(wanted?.particle)) {
      $('particle').value = wanted.particle;
    }
    const axis = 'xyz'[facts.phase?.[0] === this.id ? facts.phase[1] : 0];
    this.offer({vertical: wanted?.vertical ?? `v${axis} (m/s)`, horizontal: wanted?.horizontal ?? `${axis} (m)`});
    this.renew();
    this.startReference(referenceOf(sent, facts, structure, 1e-10));
  }

  forget() {
    $('particle').replaceChildren(new Option(TEXTS.noParticle, ''));
  }

  /** The particles, first one that can move; in a scene with births they come and go. */
  list(structure) {
    const before = this.id, first = this.facts.phase?.[0], {ids, fixed} = structure;
    this.others = ids.slice(0, MOST_OTHERS);
    if (ids.join() !== [...$('particle').options].map(option => option.value).join()) {
      $('particle').replaceChildren(...ids.map(id => new Option(id)));
      $('particle').value = ids.includes(before) ? before
          : ids.includes(first) ? first : ids.find((id, i) => !fixed[i]);
      if (before !== this.id) {
        this.renew();
      }
    }
  }

  pick(id) {
    $('particle').value = id;
    this.renew();
  }

  /** Other curves, or other runs. */
  renew() {
    if (!this.facts) {
      return;
    }
    this.offer({vertical: $('vertical').value, horizontal: $('horizontal').value});
    this.changed();
    this.plot.start(this.question().quantities, COLOURS.slice(0, this.runs()));
    $('oneCurve').hidden = !this.kept.length;
    this.ask();
  }

  /** Asks for all steps, also those between the moments shown. */
  ask() {
    if (this.id) {
      this.askRuns(this.question());
      this.reference?.postMessage(this.question());
    }
  }

  question() {
    return {type: 'phase', quantities: [this.chosen('horizontal'), this.chosen('vertical'), ...this.kept]};
  }

  /** What a run answers: the first has number 0. */
  answer(run, message) {
    if (this.isChosen(message)) {
      this.plot.set(run, message.points);
    }
  }

  /** The first run is shown at this time (s). */
  reach(time) {
    this.time = time;
    this.runReference();
  }

  /** The reference runs for as long as it may and, beyond that, until it is where the picture is. */
  runReference() {
    const done = this.done;
    if (this.reference && !done.running && !done.over && (done.reached < this.time
        || done.milliseconds < AHEAD && done.reached < this.facts.duration)) {
      done.running = true;
      this.reference.postMessage({type: 'run', milliseconds: SLICE});
      this.reference.postMessage(this.question());
    }
  }

  startReference(opening) {
    this.reference?.terminate();
    this.reference = null;
    this.done = {milliseconds: 0, reached: 0};
    $('ghost').hidden = true;
    if (!opening) {
      return;
    }
    this.reference = new Worker(this.engine);
    this.reference.onmessage = ({data}) => {
      if (data.type === 'phase' && this.isChosen(data)) {
        this.plot.setReference(data.points);
        $('ghost').hidden = false;
      } else if (data.type === 'ran') {
        this.done = {milliseconds: this.done.milliseconds + SLICE, reached: data.reached,
          over: data.over || data.failure};
        this.runReference();
      }
    };
    this.reference.postMessage({...opening, endless: true});
    this.runReference();
  }
}
