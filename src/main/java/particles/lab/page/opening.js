// What the page knows before its engine runs: the solvers, and what the engine tells of the first scene at its start.
import {unpack} from './packing.js';

/** The name of the first scene and, unless it is the scene's own, its solver. */
export const FIRST = document.querySelector('script.scene[data-first]').dataset;

const {solvers, facts, start} = FIRST.opening ? JSON.parse(await unpack(FIRST.opening)) : {solvers: []};

/** The catalogue's solvers, and the names of students' own. */
export const SOLVERS = [...solvers, ...(FIRST.own ?? '').split(' ').filter(name => name).map(name => ({name}))];
/** The engine's messages; none of a recorded run, or where a law of your own takes part. */
export const OPENING = start ? [{type: 'opened', run: 1, facts: JSON.parse(facts)}, firstFrame()] : [];

function firstFrame() {
  const [status, ids, floats] = start;
  const numbers = new Float32Array(Uint8Array.from(atob(floats), letter => letter.charCodeAt(0)).buffer);
  const names = JSON.parse(ids), state = 6 * names.length, energies = state + 1 + JSON.parse(facts).energies.length;
  return {type: 'frame', ...JSON.parse(status), state: numbers.subarray(0, state),
    path: new Float32Array(), energies: numbers.subarray(state, energies), points: [],
    structure: {ids: names, numbers: numbers.subarray(energies)}};
}
