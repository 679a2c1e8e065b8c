// The energies of the moment shown, as bars beside their curves.
import {$, few, make} from './dom.js';
import {colourOf} from './plots.js';

/** energy: their plot; time: of the moment (s) */
export function showBars(energy, time) {
  const columns = energy.shown(), times = columns[0], now = times.findLastIndex(one => one <= time);
  const part = (time - times[now]) / (times[now + 1] - times[now]) || 0;
  const kept = energy.names.slice(0, -1).map((name, i) => ({name, column: columns[i + 1]}))     // without the error
      .filter(({column}, i) => now >= 0 && energy.plot.series[i + 1].show);
  const [low, high] = kept.flatMap(({column}) => column).reduce(([least, most], value) =>
      [Math.min(least, value), Math.max(most, value)], [0, 0]);
  const percent = joules => 100 * joules / (high - low || 1) + '%';
  $('bars').replaceChildren(...kept.map(({name, column: {[now]: before, [now + 1]: after = before}}) => {
    const joules = before + part * (after - before);
    const bar = make('span');
    Object.assign(bar.style, {background: colourOf(name), width: percent(Math.abs(joules)),
      marginLeft: percent(Math.min(joules, 0) - low)});
    return make('div', {}, name + ' ' + few(joules, 3) + ' J', bar);
  }));
}
