// The energies over time and the phase space of one particle, drawn as the run goes.
// By Okabe and Ito: people with any colour vision can tell them apart.
const COLOURS = ['#d55e00', '#0072b2', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#8c6d1f', '#7f7f7f'];
const MOST = 4000;                      // points of a curve; then every second is dropped

const ink = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const short = v => v !== 0 && (Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3) ? v.toExponential(1) : String(v);
const axes = (x, y) => [x, y].map((label, i) => ({label, values: (u, values) => values.map(short),
  size: i ? 62 : 44, labelSize: 20, stroke: () => ink('--ink'),
  grid: {stroke: () => ink('--line'), width: 1}, ticks: {stroke: () => ink('--line')}}));
const size = element => ({width: Math.max(240, element.clientWidth), height: 240});

export class EnergyPlot {
  constructor(element) {
    this.element = element;
  }

  start(names) {
    this.names = names;
    this.clear();
    this.plot?.destroy();
    this.plot = new uPlot({...size(this.element), axes: axes('time (s)', ''),
      scales: {x: {time: false, range: (u, low, high) => [0, high > 0 ? high : 1]}},
      cursor: {drag: {x: false, y: false}},
      series: [{label: 'time (s)', value: (u, v) => v?.toPrecision(4) ?? ''},
        ...names.map((label, i) => ({label, show: false,
        stroke: COLOURS[i % COLOURS.length], width: i === 0 ? 2.5 : 1.5, dash: i === names.length - 1 ? [4, 3] : [],
        value: (u, v) => v?.toPrecision(4) ?? ''}))]}, this.data, this.element);
  }

  clear() {
    this.data = [[], ...this.names.map(() => [])];
    this.lastKept = -Infinity;
    this.stride = 0;
  }

  add(time, energies) {
    const times = this.data[0];
    if (times.length && time <= times[times.length - 1] || time < this.lastKept + this.stride) {
      return;
    }
    this.lastKept = time;
    times.push(time);
    energies.forEach((energy, i) => {
      this.data[i + 1].push(energy);
      if (energy && !this.plot.series[i + 1].show) {
        this.plot.setSeries(i + 1, {show: true});       // an effect that stores nothing has no curve
      }
    });
    if (times.length > MOST) {
      this.data = this.data.map(column => column.filter((value, i) => i % 2 === 0));
      this.stride = 2 * time / MOST;
    }
    this.stale = true;
  }

  draw() {
    if (this.stale) {
      this.plot.setData(this.data);
      this.stale = false;
    }
  }

  resize() {
    this.plot?.setSize(size(this.element));
  }
}

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
      if (dots) {
        c.moveTo(x, y);
        c.arc(x, y, 5 * devicePixelRatio, 0, 2 * Math.PI);
      } else if (i) {
        c.lineTo(x, y);
      } else {
        c.moveTo(x, y);
      }
    }
    dots ? c.fill() : c.stroke();
    c.restore();
    return null;
  };
}

export class PhasePlot {
  constructor(element) {
    this.element = element;
  }

  start(axis) {
    const facets = [{scale: 'x', auto: true}, {scale: 'y', auto: true}];
    this.data = [null, [[], []], [[], []], [[], []]];
    this.plot?.destroy();
    const range = (u, low, high, scale) => this.ranges(u)[scale];
    this.plot = new uPlot({...size(this.element), height: 300, mode: 2, axes: axes(axis + ' (m)', 'v (m/s)'),
      scales: {x: {time: false, range}, y: {range}}, legend: {show: false}, cursor: {show: false},
      series: [{}, {facets, stroke: () => ink('--line'), width: 7, paths: polyline(false)},
        {facets, stroke: COLOURS[1], width: 1.5, paths: polyline(false)},
        {facets, stroke: COLOURS[0], width: 1, paths: polyline(true)}]}, this.data, this.element);
  }

  /** A metre is as long as a metre a second where both fit: with omega = 1 an exact circle is seen as one. */
  ranges(u) {
    const all = k => u.data.slice(1).flatMap(curve => curve[k]);
    const [x, y] = [0, 1].map(k => all(k).reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)],
        [Infinity, -Infinity])).map(([low, high]) => low > high ? [-1, 1] : low === high ? [low - 1, high + 1]
        : [low - 0.05 * (high - low), high + 0.05 * (high - low)]);
    const width = u.bbox.width || 1, height = u.bbox.height || 1;
    const [across, up] = [(x[1] - x[0]) / width, (y[1] - y[0]) / height];         // per pixel
    const widen = ([low, high], factor) => [(low + high) / 2 - factor * (high - low) / 2,
      (low + high) / 2 + factor * (high - low) / 2];
    return Math.max(across / up, up / across) > 3 ? {x, y}
        : {x: widen(x, Math.max(1, up / across)), y: widen(y, Math.max(1, across / up))};
  }

  /** points: time, position, velocity, one after the other */
  set(points) {
    const [xs, ys] = this.data[2] = [[], []];
    for (let i = 0; i < points.length; i += 3) {
      xs.push(points[i + 1]);
      ys.push(points[i + 2]);
    }
    this.stale = true;
  }

  setReference(points) {
    const [xs, ys] = this.data[1] = [[], []];
    for (let i = 0; i < points.length; i += 3) {
      xs.push(points[i + 1]);
      ys.push(points[i + 2]);
    }
    this.stale = true;
  }

  add(x, v, isNew) {
    this.data[3] = [[x], [v]];
    const [xs, ys] = this.data[2];
    if (isNew) {
      xs.push(x);
      ys.push(v);
      if (xs.length > MOST) {
        this.data[2] = [xs, ys].map(column => column.filter((value, i) => i % 2 === 0));
      }
    }
    this.stale = true;
  }

  draw() {
    if (this.stale) {
      this.plot.setData(this.data);
      this.stale = false;
    }
  }

  resize() {
    this.plot?.setSize({...size(this.element), height: 300});
  }
}
