// Files of what is seen and was computed: pictures, a film, tables of numbers. And how fast all of it goes.
import {$, few, ink, make} from './dom.js';
import {save} from './packing.js';

const INK = '#1b2430', PAPER = '#ffffff', FILM_RATE = 30, WIDTH = 1920, HEIGHT = 1080, LINE = 36;

/** Draws the picture with its arrows and labels on a canvas, and lines of text below. */
function compose(element, canvas, lines) {
  const picture = element.querySelector('canvas'), scale = picture.width / element.clientWidth;
  const c = canvas.getContext('2d');
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.drawImage(picture, 0, 0);
  c.scale(scale, scale);
  c.textBaseline = 'middle';
  for (const path of element.querySelectorAll('svg path[d]')) {
    const {stroke, fill, strokeWidth, strokeDasharray} = getComputedStyle(path);
    const line = new Path2D(path.getAttribute('d'));
    Object.assign(c, {strokeStyle: stroke, fillStyle: fill, lineWidth: parseFloat(strokeWidth)});
    c.setLineDash(strokeDasharray === 'none' ? [] : strokeDasharray.split(/[ ,]+/).map(parseFloat));
    fill === 'none' || c.fill(line);
    c.stroke(line);
  }
  c.setLineDash([]);
  const corner = element.getBoundingClientRect();
  for (const name of element.querySelectorAll('.name:not([hidden]), svg text')) {
    const box = name.getBoundingClientRect(), {color, backgroundColor} = getComputedStyle(name);
    const plain = name.tagName === 'text';
    c.font = '12px system-ui, sans-serif';
    c.fillStyle = plain ? PAPER : backgroundColor;
    c.globalAlpha = 0.85;
    c.fillRect(box.left - corner.left, box.top - corner.top, box.width, box.height);
    c.globalAlpha = 1;
    c.fillStyle = plain ? INK : color;
    c.fillText(name.textContent, box.left - corner.left + (plain ? 0 : 3), (box.top + box.bottom) / 2 - corner.top);
  }
  c.setTransform(1, 0, 0, 1, 0, 0);
  Object.assign(c, {font: LINE * 0.7 + 'px system-ui, sans-serif', fillStyle: PAPER, globalAlpha: 0.85});
  c.fillRect(0, HEIGHT - LINE * lines.length, Math.max(...lines.map(line => c.measureText(line).width)) + LINE, HEIGHT);
  Object.assign(c, {fillStyle: INK, globalAlpha: 1});
  lines.forEach((line, i) => c.fillText(line, LINE / 2, HEIGHT + LINE * (i + 0.5 - lines.length)));
}

/** Draws a plot once as wide as a picture; with a ground, the names of its curves, and lines. */
function plotImage({plot, element}, lines) {
  const {hooks, ctx, width, height} = plot, drawn = ctx.canvas, scale = 2, k = scale / devicePixelRatio;
  const names = [...element.querySelectorAll('.u-series')].slice(1).filter(row => !row.hidden);   // the first is time
  return new Promise(done => {
    hooks.drawClear = [() => {
      Object.assign(drawn, {width: k * drawn.width, height: k * drawn.height});
      ctx.scale(k, k);
    }];
    hooks.draw = [() => {
      hooks.drawClear = hooks.draw = [];
      const height = drawn.height + 18 * scale * (names.length + lines.length);
      const canvas = make('canvas', {width: WIDTH, height}), c = canvas.getContext('2d');
      c.fillStyle = ink('--panel');
      c.fillRect(0, 0, canvas.width, canvas.height);
      c.drawImage(drawn, 0, 0);
      c.scale(scale, scale);
      c.font = '12px system-ui, sans-serif';
      names.forEach((row, i) => {
        const y = drawn.height / scale + 18 * i;
        c.fillStyle = getComputedStyle(row.querySelector('.u-marker')).borderTopColor;
        c.fillRect(12, y + 2, 10, 10);
        c.fillStyle = ink('--ink');
        c.fillText(row.querySelector('.u-label').textContent, 28, y + 11);
      });
      c.fillStyle = ink('--ink');
      lines.forEach((line, i) => c.fillText(line, 12, drawn.height / scale + 18 * (names.length + i) + 11));
      done(canvas);
      queueMicrotask(() => plot.setSize({width, height}));      // after this drawing
    }];
    plot.setSize({width: WIDTH / scale, height: HEIGHT / scale});
  });
}

const savePicture = (name, canvas) => canvas.toBlob(blob => save(name + '.png', blob));

/** The buttons that save pictures. name(): the beginning of the files' names; lines(): what is written into them */
export function offer(name, lines, film, energy, phase) {
  $('savePicture').onclick = () => savePicture(name(), film.picture());
  $('saveEnergy').onclick = async () => savePicture(name() + '-energy', await plotImage(energy, lines()));
  $('savePhase').onclick = async () => savePicture(name() + '-phase', await plotImage(phase, lines()));
  $('film').onclick = () => film.toggle(name);
}

export class Film {
  /** view: the picture; lines(): what is written into it; told(text): what there is to say */
  constructor(view, lines, told) {
    Object.assign(this, {view, lines, told});
  }

  /** Gives the picture the size of films, or its own again. */
  resize(on) {
    const {view: {element, renderer}} = this, {clientWidth, clientHeight} = element.parentElement;
    const width = 16 * Math.floor(Math.min(clientWidth / 16, clientHeight / 9));
    Object.assign(element.style, on ? {width: width + 'px', height: 9 * width / 16 + 'px'} : {width: '', height: ''});
    renderer.setPixelRatio(on ? (WIDTH + 0.5) / width : Math.min(2, devicePixelRatio));       // it is rounded down
    this.view.resize();
    this.view.draw();
  }

  picture() {
    const canvas = make('canvas', {width: WIDTH, height: HEIGHT});
    this.recorder || this.resize(true);
    compose(this.view.element, canvas, this.lines());
    this.recorder || this.resize(false);
    return canvas;
  }

  /** Starts to record or, if it does, ends and saves the film under the name() of what it ends with. */
  toggle(name) {
    if (this.recorder) {
      this.recorder.stop();
      return;
    }
    const type = ['video/webm;codecs=vp9', 'video/webm', 'video/mp4']
        .find(one => window.MediaRecorder?.isTypeSupported(one));
    if (!type) {
      this.told(TEXTS.noFilms);
      return;
    }
    this.canvas = this.picture();
    this.resize(true);
    this.recorder = new MediaRecorder(this.canvas.captureStream(FILM_RATE), {mimeType: type,
      videoBitsPerSecond: 6e6});
    const parts = [];
    this.recorder.ondataavailable = ({data}) => parts.push(data);
    this.recorder.onstop = () => {
      this.recorder = null;
      this.resize(false);
      $('film').textContent = TEXTS.elements.film;
      this.told('');
      save(name() + (type.includes('mp4') ? '.mp4' : '.webm'), new Blob(parts, {type}));
    };
    this.recorder.start();
    $('film').textContent = TEXTS.endFilm;
    this.told(TEXTS.recording);
  }

  /** The picture has been drawn anew. */
  drawn() {
    if (this.recorder) {
      compose(this.view.element, this.canvas, this.lines());
    }
  }
}

/** Measures how fast simulated time passes, over the last second. */
export class Rates {
  /** Another scene is not as fast. */
  forget() {
    this.moments = [];
    $('pace').textContent = '';
  }

  /** A moment was drawn at a time of the clock on the wall (ms). */
  drew(now, time) {
    this.moments = this.moments.filter(one => one.now > now - 1000 && one.time <= time);
    this.moments.push({now, time});
    const first = this.moments[0], seconds = (now - first.now) / 1000;
    if (seconds > 0.25) {
      $('pace').textContent = few((time - first.time) / seconds, 2) + ' s/s';
    }
  }
}
