// How far each run is from a reference: the first run's scene, computed as exactly as the page can. It is computed with
// two tolerances: their difference is the uncertainty of the reference.
import {$, few} from './dom.js';
import {referenceOf} from './phase.js';

const TOLERANCES = [1e-10, 1e-9];
const MOST_WAITING = 100, MOST_KNOWN = 500;     // moments that a slow reference has still to compute; that are kept
const CLEAR = 2, PARTED = 0.1;          // times nearer than the next; of the motion's size
const key = time => Math.round(time * 1e9);

export class Nearest {
  /** plot: of the distances over time; runs(): names of the runs, and whether each has the scene of the first */
  constructor(engine, plot, runs) {
    Object.assign(this, {engine, plot, runs, workers: []});
  }

  /** A new scene, or other runs. */
  start(sent, facts, structure) {
    this.close();
    const openings = TOLERANCES.map(tolerance => referenceOf(sent, facts, structure, tolerance));
    $('nearestSection').hidden = !openings[0];
    $('nearest').textContent = '';
    if (!openings[0]) {
      return;
    }
    this.names = this.runs();
    this.plot.start(this.names);
    Object.assign(this, {known: new Map(), latest: -1, origin: null, size: 0, waiting: 0, ids: structure.ids.join()});
    this.workers = openings.map((opening, i) => {
      const worker = new Worker(this.engine);
      worker.onmessage = ({data}) => data.type === 'sample' && this.take(data, 'reference' + i);
      worker.postMessage(opening);
      return worker;
    });
  }

  /** A particle is dragged; the reference has no such pull. */
  pulled() {
    if (this.workers.length) {
      this.close();
      $('nearest').textContent = 'Your pull has ended the comparison with the reference.';
    }
  }

  close() {
    this.workers.splice(0).forEach(worker => worker.terminate());
  }

  /** A moment of a run; the first has number 0, and its times are those that all are compared at. */
  add(run, frame, structure) {
    if (!this.workers.length || structure?.ids.join() !== this.ids) {
      return;
    }
    if (run === 0 && !frame.looking && this.waiting < MOST_WAITING && frame.time > this.latest) {
      this.latest = frame.time;                     // the reference cannot go back
      this.known.set(key(frame.time), {time: frame.time});
      this.waiting++;
      if (this.known.size > MOST_KNOWN) {
        this.known.delete(this.known.keys().next().value);
      }
      this.workers.forEach(worker => worker.postMessage({type: 'sample', time: frame.time}));
    }
    this.take(frame, run);
  }

  take({time, state}, who) {
    const moment = this.known.get(key(time));
    this.waiting -= who === 'reference0' ? 1 : 0;
    if (!moment) {
      return;
    }
    moment[who] = state;
    if (moment.reference0 && moment.reference1) {
      this.measure(moment);
    }
  }

  measure(moment) {
    const {time, reference0, reference1} = moment;
    const uncertainty = distance(reference0, reference1);
    this.origin ??= reference0;
    this.size = Math.max(this.size, distance(reference0, this.origin));
    const distances = this.names.map((name, run) => moment[run] && distance(moment[run], reference0));
    distances.forEach((metres, run) => metres !== undefined && this.plot.add(run, time, metres));
    if (!distances.includes(undefined)) {
      $('nearest').textContent = 'At ' + few(time) + ' s: '
          + this.names.map(({name}, run) => name + ' ' + few(distances[run], 2) + ' m').join(', ') + '. '
          + verdict(this.names, distances, uncertainty, this.size);
    }
  }
}

/** The root mean square of the distances of all particles in two states (m). */
function distance(one, other) {
  let sum = 0;
  for (let i = 0; i < one.length; i += 6) {
    sum += (one[i] - other[i]) ** 2 + (one[i + 1] - other[i + 1]) ** 2 + (one[i + 2] - other[i + 2]) ** 2;
  }
  return Math.sqrt(6 * sum / one.length);
}

/** Which run is nearest, only where that is clear. size: how far the reference has moved (m) */
function verdict(names, distances, uncertainty, size) {
  const order = distances.map((metres, run) => ({metres, ...names[run]})).filter(run => run.same)
      .sort((a, b) => a.metres - b.metres);
  const [first, second] = order;
  if (!second) {
    return '';
  }
  // the states that are compared have seven digits
  return first.metres > PARTED * size ? 'All have left the reference.'
      : second.metres <= Math.max(3 * uncertainty, 1e-6 * size) ? 'No difference that the reference can tell.'
      : second.metres < CLEAR * first.metres ? 'No clear difference.' : 'Nearest: ' + first.name + '.';
}
