// Files of what is seen and was computed: pictures, a film, tables of numbers. And how fast all of it goes.
import {$, few, ink} from './dom.js';
import {save} from './packing.js';

const INK = '#1b2430', PAPER = '#ffffff', FILM_RATE = 30, WIDTH = 1920, HEIGHT = 1080;

/** The picture with its arrows and labels, on a canvas of its own or on one that is given. */
function composed(element, canvas = document.createElement('canvas')) {
  const picture = element.querySelector('canvas'), scale = picture.width / element.clientWidth;
  if (canvas.width !== picture.width || canvas.height !== picture.height) {
    Object.assign(canvas, {width: picture.width, height: picture.height});
  }
  const c = canvas.getContext('2d');
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.drawImage(picture, 0, 0);
  c.scale(scale, scale);
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
    c.textBaseline = 'middle';
    c.fillStyle = plain ? PAPER : backgroundColor;
    c.globalAlpha = 0.85;
    c.fillRect(box.left - corner.left, box.top - corner.top, box.width, box.height);
    c.globalAlpha = 1;
    c.fillStyle = plain ? INK : color;
    c.fillText(name.textContent, box.left - corner.left + (plain ? 0 : 3), (box.top + box.bottom) / 2 - corner.top);
  }
  return canvas;
}

/** Draws a plot once as wide as a picture; with a ground, as its own canvas has none, and the names of its curves. */
function plotImage({plot, element}) {
  const {hooks, ctx, width, height} = plot, drawn = ctx.canvas, scale = 2, k = scale / devicePixelRatio;
  const names = [...element.querySelectorAll('.u-series')].slice(1).filter(row => !row.hidden);   // the first is time
  return new Promise(done => {
    hooks.drawClear = [() => {
      Object.assign(drawn, {width: k * drawn.width, height: k * drawn.height});
      ctx.scale(k, k);
    }];
    hooks.draw = [() => {
      hooks.drawClear = hooks.draw = [];
      const canvas = document.createElement('canvas'), c = canvas.getContext('2d');
      Object.assign(canvas, {width: WIDTH, height: drawn.height + 18 * scale * names.length});
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
      done(canvas);
      queueMicrotask(() => plot.setSize({width, height}));      // after this drawing
    }];
    plot.setSize({width: WIDTH / scale, height: HEIGHT / scale});
  });
}

const savePicture = (name, canvas) => canvas.toBlob(blob => save(name + '.png', blob));

/** The buttons that save pictures. name(): the beginning of the files' names */
export function offer(name, film, energy, phase) {
  $('savePicture').onclick = () => savePicture(name(), composed($('view')));
  $('saveEnergy').onclick = async () => savePicture(name() + '-energy', await plotImage(energy));
  $('savePhase').onclick = async () => savePicture(name() + '-phase', await plotImage(phase));
  $('film').onclick = () => film.toggle(name);
}

export class Film {
  /** element: the picture; told(text): what there is to say */
  constructor(element, told) {
    Object.assign(this, {element, told});
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
      this.told('This browser cannot record films.');
      return;
    }
    this.canvas = composed(this.element);
    this.recorder = new MediaRecorder(this.canvas.captureStream(FILM_RATE), {mimeType: type,
      videoBitsPerSecond: 6e6});
    const parts = [];
    this.recorder.ondataavailable = ({data}) => parts.push(data);
    this.recorder.onstop = () => {
      this.recorder = null;
      $('film').textContent = 'Film';
      this.told('');
      save(name() + (type.includes('mp4') ? '.mp4' : '.webm'), new Blob(parts, {type}));
    };
    this.recorder.start();
    $('film').textContent = 'End the film';
    this.told('Recording: "End the film" saves it.');
  }

  /** The picture has been drawn anew. */
  drawn() {
    if (this.recorder) {
      composed(this.element, this.canvas);
    }
  }
}

/** Measures how fast simulated time passes, over the last second. */
export class Rates {
  constructor() {
    this.forget();
  }

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
