// The energies over time and the phase space of one particle, drawn as the run goes.
import {$, few, ink} from './dom.js';

// By Okabe and Ito, and four that differ from those: people with any colour vision can tell them apart. An energy has
// one colour in all scenes.
const COLOURS = ['#d55e00', '#0072b2'];
const OF_ENERGIES = {total: COLOURS[0], kinetic: COLOURS[1], gravity: '#009e73', springs: '#cc79a7',
  attraction: '#e69f00', cohesion: '#56b4e9', penaltyPlane: '#6900ff', penaltySphere: '#b41e2d', repulsion: '#96b45a',
  'numerical error': '#7f7f7f'}, OF_OWN = '#4b78ff';
const MORE = Object.values(OF_ENERGIES).slice(2);
const MOST = 4000;                      // points of a curve; then every second is dropped
const FEW = 150;                        // points that are dots as well

// a logarithmic axis has no numbers at some of its lines
const short = v => v === null ? ''
    : v !== 0 && (Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3) ? v.toExponential(1) : String(v);
/** How large the type is, and how thick lines are with it, where 1 is usual. */
const scale = () => parseFloat(getComputedStyle(document.body).getPropertyValue('--type')) / 12;
const axes = (x, y) => [x, y].map((label, i) => ({label,
  values: (u, values) => i && u.data[0]?.length < 2 ? [] : values.map(short),       // of one moment they mean nothing
  size: (i ? 62 : 44) * scale(), labelSize: 20 * scale(), font: 12 * scale() + 'px system-ui, sans-serif',
  labelFont: 'bold ' + 12 * scale() + 'px system-ui, sans-serif', stroke: () => ink('--ink'),
  grid: {stroke: () => ink('--line'), width: 1}, ticks: {stroke: () => ink('--line')}}));
const size = element => ({width: Math.max(240, element.clientWidth),
  height: parseFloat(getComputedStyle(element).getPropertyValue('--height')) || 240});
export const colourOf = name => OF_ENERGIES[name] ?? OF_OWN;
/** The value at the cursor or, where there is none, the latest. */
const latest = (u, value, series) => (value ?? u.data[series][u.data[series].length - 1])?.toPrecision(4) ?? '';

class Plot {
  constructor(element) {
    this.element = element;
  }

  resize() {
    this.plot?.setSize(size(this.element));
  }
}

export class EnergyPlot extends Plot {
  /** names: of the energies; uniform: the numbers of those whose zero is their lowest value so far; duration (s) */
  start(names, uniform, duration) {
    this.names = names;
    this.duration = duration;
    this.uniform = uniform;
    this.data = [[], ...names.map(() => [])];
    this.lastKept = -Infinity;
    this.stride = 0;
    this.build();
  }

  build() {
    this.plot?.destroy();
    const error = this.names.length - 1;
    const [time, energy] = axes(TEXTS.timeAxis, TEXTS.energyAxis);
    this.plot = new uPlot({...size(this.element), axes: [time, energy, {...axes('', TEXTS.errorAxis)[1],
      scale: 'error', side: 1, grid: {show: false}}],
      scales: {x: {time: false, range: (u, low, high) => [0, u.data[0].at(-1) > 0 ? high : this.duration]},
        error: this.logarithmic ? {distr: 3} : {range: rangeOfErrors}},
      cursor: {drag: {x: false, y: false}},
      series: [{label: TEXTS.timeAxis, value: latest},
        ...this.names.map((name, i) => ({label: this.uniform.includes(i) ? TEXTS.fromLowest(name) : name,
        show: false, stroke: colourOf(name), width: (i === 0 ? 2.5 : 1.5) * scale(), scale: i === error ? 'error' : 'y',
        dash: i === error ? [4, 3] : [], value: latest}))]}, this.shown(), this.element);
    this.rows = [...this.plot.root.querySelectorAll('.u-series')];
    this.rows.forEach((row, i) => { row.hidden = i > 0; });
    this.stale = true;
  }

  /** rows: the time and the energies after each step, one after the other */
  add(rows) {
    const width = this.names.length + 1, times = this.data[0];
    for (let r = 0; r < rows.length; r += width) {
      const time = rows[r];
      if (times.length && time <= times[times.length - 1] || time < this.lastKept + this.stride) {
        continue;
      }
      this.lastKept = time;
      for (let i = 0; i < width; i++) {
        this.data[i].push(rows[r + i]);
      }
      if (times.length > MOST) {
        thin(this.data);
        this.stride = 2 * time / MOST;
      }
      this.stale = true;
    }
  }

  /** The columns with gravity's zero at its lowest, as in energy.png, and on a logarithmic axis no zeros. */
  shown() {
    const columns = [...this.data];
    for (const i of this.uniform) {
      const low = columns[i + 1].reduce((least, value) => Math.min(least, value), Infinity);
      columns[i + 1] = columns[i + 1].map(value => value - low);
      columns[1] = columns[1].map(value => value - low);
    }
    const error = columns.length - 1;
    columns[error] = this.logarithmic ? columns[error].map(value => Math.abs(value) || null) : columns[error];
    return columns;
  }

  setLogarithmic(on) {
    this.logarithmic = on;
    this.build();
  }

  draw() {
    if (this.stale) {
      this.data.forEach((column, i) => {        // an effect that stores nothing has no curve
        if (i && !this.plot.series[i].show && column.some(value => value)) {
          this.plot.setSeries(i, {show: true});
          this.rows[i].hidden = false;
        }
      });
      this.plot.setData(this.shown());
      this.stale = false;
    }
  }
}

/** The axis reaches at least this far (J): of round-off alone, it would be from 0 to 100. */
const rangeOfErrors = (u, low, high) => low === null ? [null, null]
    : uPlot.rangeNum(low, Math.max(high, 1e-9), 0.1, true);

/** Drops every second point of a long curve. */
function thin(curve) {
  while (curve[0].length > MOST) {
    curve.forEach(column => column.splice(0, Infinity, ...column.filter((value, k) => k % 2 === 0)));
  }
}

const line = (label, stroke) => ({facets: ['x', 'y'].map(scale => ({scale, auto: true})), label, stroke,
  width: 1.5 * scale(), paths: polyline(false)});

/** The distances of several runs from a reference. */
export class DistancePlot extends Plot {
  /** runs: the name of each, and the colour of each but the first; duration: of the scene (s) */
  start(runs, duration) {
    this.data = [null, ...runs.map(() => [[], []])];
    this.plot?.destroy();
    const [time, distance] = axes(TEXTS.timeAxis, TEXTS.distanceAxis);
    this.plot = new uPlot({...size(this.element), mode: 2,
      axes: [time, {...distance, splits: decades, filter: (u, splits) => splits}],
      scales: {x: {time: false, range: [0, duration]}, y: {distr: 3}}, cursor: {show: false},
      legend: {show: true, live: false},
      series: [{}, ...runs.map(({name, colour = COLOURS[1]}) => line(name, colour))]}, this.data, this.element);
  }

  /** A point of a run's curve; 0 has no place on the axis. */
  add(run, time, metres) {
    if (metres > 0) {
      this.data[1 + run][0].push(time);
      this.data[1 + run][1].push(metres);
      this.stale = true;
    }
  }

  draw() {
    if (this.stale && this.plot && this.element.offsetParent) {
      this.plot.setData(this.data);
      this.stale = false;
    }
  }
}

/** A few powers of ten in a range. */
function decades(u, axis, low, high) {
  const from = Math.ceil(Math.log10(low)), to = Math.floor(Math.log10(high)), step = Math.ceil((to - from + 1) / 5);
  return Array.from({length: Math.max(0, Math.floor((to - from) / step) + 1)}, (none, k) => 10 ** (from + k * step));
}

/** Straight lines, with dots where the points are few; or dots alone. */
function polyline(dots) {
  return (u, index) => {
    const [xs, ys] = u.data[index];
    const c = u.ctx;
    c.save();
    c.beginPath();
    c.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    c.clip();
    c.beginPath();
    c.strokeStyle = c.fillStyle = u.series[index].stroke(u, index);
    c.lineWidth = u.series[index].width * devicePixelRatio;
    for (let i = 0; i < xs.length; i++) {
      const x = u.valToPos(xs[i], 'x', true), y = u.valToPos(ys[i], 'y', true);
      i && !dots ? c.lineTo(x, y) : c.moveTo(x, y);
    }
    c.stroke();
    const radius = dots ? 5 : u.series[index].dots && xs.length <= FEW ? 2.5 : 0;
    for (let i = 0; i < xs.length && radius > 0; i++) {
      c.beginPath();
      c.arc(u.valToPos(xs[i], 'x', true), u.valToPos(ys[i], 'y', true), radius * devicePixelRatio, 0, 2 * Math.PI);
      c.fill();
    }
    c.restore();
    return null;
  };
}

export class PhasePlot extends Plot {
  /** quantities: the horizontal one, and those over it; others: the colours of other runs' curves of the first */
  start(quantities, others = []) {
    const [across, ...up] = quantities;
    const names = up.map(({label, id}) => up.length > 1 ? TEXTS.of(label, id) : label);
    this.quantities = quantities;
    // of each run, the times and the values
    this.curves = [quantities, ...others.map(() => quantities.slice(0, 2))].map(one => [[], ...one.map(() => [])]);
    const [first, ...more] = this.curves, curve = (one, k) => [one[1], one[k]];
    this.data = [null, [[], []], curve(first, 2), [[], []], ...up.slice(1).map((none, k) => curve(first, 3 + k)),
      ...more.map(one => curve(one, 2))];
    this.plot?.destroy();
    const range = (u, low, high, scale) => this.ranges(u)[scale];
    this.plot = new uPlot({...size(this.element), mode: 2,
      axes: axes(across.label, [...new Set(up.map(({label}) => label))].join(', ')),
      scales: {x: {time: false, range}, y: {range}},
      legend: {show: up.length > 1, live: false}, cursor: {show: false},
      series: [{}, {...line(TEXTS.reference, () => ink('--line')), width: 7},
        {...line(names[0], COLOURS[1]), dots: true}, {...line(TEXTS.marks, COLOURS[0]), paths: polyline(true)},
        ...names.slice(1).map((name, k) => line(name, MORE[k % MORE.length])),
        ...others.map((colour, k) => line(TEXTS.run(k + 2), colour))]}, this.data, this.element);
  }

  /** A metre is as long as a metre a second where both fit: with omega = 1 an exact circle is seen as one. */
  ranges(u) {
    const all = k => u.data.slice(1).flatMap(curve => curve[k]);
    const [x, y] = [0, 1].map(k => all(k).reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)],
        [Infinity, -Infinity])).map(([low, high]) => low > high ? [-1, 1] : low === high ? [low - 1, high + 1]
        : [low - 0.05 * (high - low), high + 0.05 * (high - low)]);
    const width = u.bbox.width || 1, height = u.bbox.height || 1, [one, other] = this.quantities;
    const [across, up] = [(x[1] - x[0]) / width, (y[1] - y[0]) / height];         // per pixel
    const widen = ([low, high], factor) => [(low + high) / 2 - factor * (high - low) / 2,
      (low + high) / 2 + factor * (high - low) / 2];
    return other.what !== one.what + 3 || Math.max(across / up, up / across) > 5 ? {x, y}
        : {x: widen(x, Math.max(1, up / across)), y: widen(y, Math.max(1, across / up))};
  }

  /** points: of a run, the times and the values after each step and last at present; in place of those before */
  set(run, points) {
    this.curves[run]?.forEach(column => column.splice(0));
    this.add(run, points);
  }

  /** Adds to a run's curve what is later than its points before. */
  add(run, points) {
    const curve = this.curves?.[run];
    if (!curve || points.length < curve.length) {
      return;
    }
    for (let i = 0; i < points[0].length - 1; i++) {
      if (!(points[0][i] <= curve[0].at(-1)) && curve.every((column, c) => !isNaN(points[c][i]))) {
        curve.forEach((column, c) => column.push(points[c][i]));
      }
    }
    thin(curve);
    if (run === 0) {
      this.now = points.slice(1, 3).map(column => column.at(-1));
    }
    this.stale = true;
  }

  setReference([, ...points]) {
    this.data[1] = points.slice(0, 2).map(column => [...column.subarray(0, -1)]);
    this.stale = true;
  }

  /** Marks where the particle is, between two steps as well and, over time, the ends of its latest period. */
  mark() {
    const period = this.quantities[0].what < 0 ? lastPeriod(this.curves[0].slice(1)) : null;
    this.data[3] = [0, 1].map(k => [this.now?.[k] ?? NaN, ...(period?.map(point => point[k]) ?? [])]);
    const [[t0, high], [, low], [t1]] = period ?? [[], [], []];
    $('period').textContent = period ? TEXTS.period(few(t1 - t0), few((high - low) / 2) + ' ' + this.quantities[1].unit)
        : '';
  }

  draw() {
    if (this.stale) {
      this.mark();
      this.plot.setData(this.data);
      this.stale = false;
    }
  }
}

/** The last two maxima of a curve and the minimum between them, each that of a parabola; null before there are two. */
function lastPeriod([times, values]) {
  const turns = [];
  for (let i = values.length - 2; i > 0 && turns.length < 3; i--) {
    const [t0, t1, t2] = times.slice(i - 1, i + 2), [v0, v1, v2] = values.slice(i - 1, i + 2);
    const sign = turns.length % 2 ? -1 : 1;
    if (sign * v1 > sign * v0 && sign * v1 >= sign * v2) {
      const slope = (v1 - v0) / (t1 - t0), bend = ((v2 - v1) / (t2 - t1) - slope) / (t2 - t0);
      const t = (t0 + t1) / 2 - slope / (2 * bend);
      turns.unshift([t, v0 + slope * (t - t0) + bend * (t - t0) * (t - t1)]);
    }
  }
  return turns.length === 3 ? turns : null;
}
