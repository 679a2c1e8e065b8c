// How far each run is from a reference, over the whole scene: the first run's scene, computed as exactly as the page
// can. It is computed with two tolerances: their difference is the uncertainty of the reference.
import {$, few} from './dom.js';
import {referenceOf} from './phase.js';

const TOLERANCES = [1e-10, 1e-9], SAMPLES = 200;
const CLEAR = 2, PARTED = 0.1;          // times nearer than the next; of the motion's size
const MAGNIFIED = 1e-3;                 // of that size too: a million times the tolerance; without chaos, at most 2e-6

export class Nearest {
  /** plot: of the distances over time */
  constructor(engine, plot) {
    Object.assign(this, {engine, plot});
  }

  /** runs: of the same scene, each with its name and what it is opened with, the first as sent says */
  start(runs, sent, facts, structure) {
    this.close();
    const openings = [...TOLERANCES.map(tolerance => referenceOf(sent, facts, structure, tolerance)),
      ...runs.map(({opening}) => ({...opening, type: 'open', endless: false}))];
    $('nearestSection').hidden = !openings[0] || runs.length < 2;
    if ($('nearestSection').hidden) {
      return;
    }
    this.plot.start(runs, facts.duration);
    Object.assign(this, {runs, samples: openings.map(() => [])});
    // one after the other, away from the runs that are seen: so all are whole, on a slow computer too
    this.worker = new Worker(this.engine);
    this.worker.onmessage = ({data}) => data.facts?.errors ? this.close()
        : (data.asked ?? data).type === 'sample' && this.take(data);
    for (const opening of openings) {
      this.worker.postMessage(opening);
      for (let k = 0; k <= SAMPLES; k++) {
        this.worker.postMessage({type: 'sample', time: k * facts.duration / SAMPLES});
      }
    }
  }

  close() {
    this.worker?.terminate();
    $('nearestSection').hidden = true;
    $('nearest').textContent = '';
  }

  take(sample) {
    const who = this.samples.findIndex(samples => samples.length <= SAMPLES), run = who - TOLERANCES.length;
    this.samples[who].push(sample);
    if (run >= 0 && this.isComparable(sample)) {
      this.plot.add(run, sample.time, distance(sample, this.samples[0][this.samples[who].length - 1]));
    }
    const isDone = this.samples.at(-1).length > SAMPLES;
    $('nearest').textContent = isDone ? this.verdict() : '...';
  }

  /** Whether a sample is of a run that goes on, and of the particles that the scene begins with. */
  isComparable({failure, ids}) {
    return failure === '' && ids === this.samples[0][0].ids;
  }

  /** The mean distances of all runs, where that is clear which is nearest, and whether the references have parted. */
  verdict() {
    const [reference, other, ...own] = this.samples;
    const times = [...reference.keys()].filter(k => [reference, other].every(one => this.isComparable(one[k])));
    const mean = (one, to) => times.reduce((sum, k) => sum + (this.isComparable(one[k]) ? distance(one[k], to(k))
        : Infinity), 0) / times.length;
    const uncertainty = mean(other, k => reference[k]);
    const size = Math.max(...times.map(k => distance(reference[k], reference[0])));
    const last = times.at(-1), apart = distance(reference[last], other[last]);
    const runs = own.map((one, i) => ({name: this.runs[i].name, metres: mean(one, k => reference[k])}));
    return TEXTS.meanDistances(few(reference[last].time), runs.map(({name, metres}) => metres < Infinity
        ? name + ' ' + few(metres, 2) + ' m' : TEXTS.stops(name))) + nearestOf(runs, uncertainty, size)
        + (apart > MAGNIFIED * size ? TEXTS.parted(few(apart, 2)) : '');
  }
}

/** The root mean square of the distances of all particles in two states (m). */
function distance({state: one}, {state: other}) {
  let sum = 0;
  for (let i = 0; i < one.length; i += 6) {
    sum += (one[i] - other[i]) ** 2 + (one[i + 1] - other[i + 1]) ** 2 + (one[i + 2] - other[i + 2]) ** 2;
  }
  return Math.sqrt(6 * sum / one.length);
}

/** Which run is nearest, only where that is clear. size: how far the reference has moved (m) */
function nearestOf(runs, uncertainty, size) {
  const [first, second] = [...runs].sort((a, b) => a.metres - b.metres);
  // the states that are compared have seven digits
  return first.metres > PARTED * size ? TEXTS.left
      : second.metres <= Math.max(3 * uncertainty, 1e-6 * size) ? TEXTS.noDifference
      : second.metres < CLEAR * first.metres ? TEXTS.notClear
      : TEXTS.nearest(first.name, second.metres < Infinity && few(second.metres / first.metres, 2),
          second.name);
}
