// The texts of scenes speak of a run's files and options; here they speak of the page.
const TASK = /\s*gradle\s+(energyDrift|race)\b[^.]*\./g;      // what another task of the program shows
const REPLACED = [[/\bphase\.png/g, 'the phase-space plot'], [/\benergy\.png/g, 'the energy plot'],
  [/-Psolver=([\w-]+)/g, '$1'], [/-PdeltaT=([\d.e-]+)/g, 'deltaT = $1'],
  [/,? and the console warns/g, '']];

export const ofPage = text => REPLACED.reduce((changed, [from, to]) => changed.replace(from, to),
    text.replace(TASK, ''));
