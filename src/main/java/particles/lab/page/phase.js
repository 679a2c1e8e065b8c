// The phase space of one particle: which, along which axis, and its curves in all runs and in a reference.
import {$} from './dom.js';
import {COLOURS} from './panels.js';

const REFERENCE_PARTICLES = 40;
const SLICE = 250, AHEAD = 4000;        // milliseconds that the reference runs between answers; before it has to wait

/** What computes a scene as exactly as the page can; null where that would take too long, or nothing can compute. */
export const referenceOf = (sent, facts, structure, tolerance) =>
    structure.ids.length > REFERENCE_PARTICLES || facts.recorded !== undefined ? null
    : {type: 'open', ...sent, solver: 'dormand-prince', tolerance, deltaT: String(facts.duration / 1000)};

export class PhaseSpace {
  /** plot: where the curves are drawn; ask(message): asks all runs; runs(): how many there are beside the first */
  constructor(plot, engine, ask, runs, changed) {
    Object.assign(this, {plot, engine, askRuns: ask, runs, changed});
    $('particle').onchange = $('axis').onchange = () => this.renew();
  }

  get id() {
    return $('particle').value;
  }

  get axis() {
    return Number($('axis').value);
  }

  isChosen(message) {
    return message.id === this.id && message.axis === this.axis;
  }

  /** A new scene. wanted: the particle and the axis of a link, or null; sent: what the scene was opened with */
  start(facts, structure, wanted, sent) {
    this.preferred = facts.phase;
    this.list(structure);
    if (structure.ids.includes(wanted?.particle)) {
      $('particle').value = wanted.particle;
      $('axis').value = wanted.axis;
    } else if (!this.id && facts.phase) {
      [$('particle').value, $('axis').value] = facts.phase;
    }
    this.renew();
    this.startReference(referenceOf(sent, facts, structure, 1e-10));
  }

  forget() {
    $('particle').replaceChildren(new Option('none yet', ''));
  }

  /** The particles that can move; in a scene with births they come and go. */
  list(structure) {
    const before = this.id, first = this.preferred?.[0];
    const ids = structure.ids.filter((id, i) => !structure.fixed[i]);
    if (ids.length && ids.join() !== [...$('particle').options].map(option => option.value).join()) {
      $('particle').replaceChildren(...ids.map(id => new Option(id)));
      $('particle').value = ids.includes(before) ? before : ids.includes(first) ? first : ids[0];
      if (before !== this.id) {
        $('axis').value = this.id === first ? this.preferred[1] : $('axis').value;
        this.renew();
      }
    }
  }

  pick(id) {
    $('particle').value = id;
    this.renew();
  }

  /** Another particle or axis, or other runs. */
  renew() {
    this.changed();
    this.plot.start('xyz'[this.axis], COLOURS.slice(0, this.runs()));
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
    return {type: 'phase', id: this.id, axis: this.axis};
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
    if (this.reference && !done.running && !done.over && (done.milliseconds < AHEAD || done.reached < this.time)) {
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
    this.reference.postMessage(opening);
    this.runReference();
  }
}
