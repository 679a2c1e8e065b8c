// Takes the place of the compiled classes in a page that shows a recorded run: a session with functions of the same
// names, which read what was recorded.
const floats = new Float32Array(Uint8Array.from(atob(RECORDED.floats), letter => letter.charCodeAt(0)).buffer);
const times = RECORDED.times, parts = RECORDED.facts.energies.length, last = times.length - 1;
const moments = [];                     // the energies and the state of each
let now = 0, at = 0;

let from = 0;
const next = length => floats.subarray(from, from += length);
const structures = RECORDED.lengths.map(next);
for (const k of RECORDED.structureOf) {
  moments.push({energies: next(parts), state: next(6 * RECORDED.ids[k].length)});
}

/** The latest moment that is not after a time, or the first. */
const find = time => Math.max(0, times.findLastIndex(one => one <= time));

const particle = () => '{}', drag = () => {}, setEndless = () => {};

function open() {
  look(times[0]);
  return JSON.stringify(RECORDED.facts);
}

function advance(time) {
  at = find(time);
  now = Math.min(time, times[last]);
}

function look(time) {
  advance(time);
  now = times[at];
}

function step() {
  look(times[Math.min(at + 1, last)]);
}

const status = () => JSON.stringify({time: now, reached: times[last], steps: RECORDED.steps[at],
  evaluations: RECORDED.evaluations[at], seconds: 0, work: {},
  over: at === last, failure: at === last ? RECORDED.failure : ''});

/** Between two moments of the same particles, on straight lines. */
function state() {
  const {state} = moments[at];
  if (at === last || now === times[at] || RECORDED.structureOf[at] !== RECORDED.structureOf[at + 1]) {
    return state;
  }
  const next = moments[at + 1].state, part = (now - times[at]) / (times[at + 1] - times[at]);
  return state.map((value, i) => value + part * (next[i] - value));
}

/** Rows of what read(k) gives, after each moment later than a time. */
const rows = (time, read) => Float32Array.from(times.flatMap((one, k) => one > time ? read(k) : []));

const states = time => rows(time, k => RECORDED.structureOf[k] === structureNumber() ? [times[k], ...moments[k].state]
    : []);
const energies = time => rows(time, k => [times[k], ...moments[k].energies]);
const structureNumber = () => RECORDED.structureOf[at];
const ids = () => JSON.stringify(RECORDED.ids[structureNumber()]);
const structure = () => structures[structureNumber()];

/** As the lab's Frame.value. */
function value(what, {time, energies, state, ids}, ...names) {
  const [i, j] = names.map(name => 6 * ids.indexOf(name)), of = by => Math.hypot(...[0, 1, 2].map(by));
  return what < 0 ? time : what > 7 ? energies[what - 8] : i < 0 ? NaN : what < 6 ? state[i + what]
      : what === 6 ? of(k => state[i + 3 + k]) : of(k => state[i + k] - state[j + k]);
}

const momentOf = k => ({time: times[k], ...moments[k], ids: RECORDED.ids[RECORDED.structureOf[k]]});
const values = (what, id, other, after) => Float32Array.from([...moments.keys()].filter(k => times[k] > after)
    .map(momentOf).concat({...momentOf(at), time: now, state: state()})
    .map(moment => value(what, moment, id, other)));

const session = () => ({open, advance, between: advance, look, step, drag, setEndless, particle, status,
  state, states, energies, structureNumber, ids, structure, values});
