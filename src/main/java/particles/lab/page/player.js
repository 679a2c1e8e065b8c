// The first run, in its worker: started, paused, stepped and looked back at by buttons, keys and the time slider.
import {$, few, make} from './dom.js';

const LONG = 1, STEPPING = ['play', 'step', 'goOn'];           // seconds

export class Player {
  /**
   * paused(): the run has stopped; restarted(): it is computed anew, and what was known of it is void; renew(): gives
   * another worker, in place of one that is in a long step
   */
  constructor(worker, {paused, restarted, renew}) {
    Object.assign(this, {worker, paused, restarted, renew, run: 0, playing: false, looking: false, autoplay: false,
      pulled: false, frame: null, waiting: Infinity});
    $('speed').value = 1;
    $('start').onclick = () => this.startOrPause();
    $('step').onclick = () => this.step();
    $('speed').onchange = () => this.playing && this.tell({type: 'play', speed: this.speed});
    $('atEnd').onchange = () => {
      this.tell({type: 'endless', endless: this.endless});
      this.frame && (this.frame.over &&= !this.endless);
      this.showStart();
    };
    $('time').oninput = () => this.look(Number($('time').value));
  }

  tell(message) {
    if (STEPPING.includes(message.type)) {
      this.waiting = performance.now();
    }
    this.worker.postMessage(message);
  }

  /** Says so when a step takes long. */
  watch(now) {
    const seconds = (now - this.waiting) / 1000, {steps, seconds: all} = this.frame ?? {};
    $('waiting').textContent = seconds < LONG ? '' : TEXTS.longStep(Math.round(seconds))
        + (steps > 0 ? TEXTS.longSteps(steps, few(all / steps, 2)) : '.');
  }

  get endless() {
    return $('atEnd').value === 'on';
  }

  get speed() {
    return Number($('speed').value);
  }

  /** Opens what is chosen, at its start; play: it moves as soon as it is there. */
  open(sent, play = this.playing || this.autoplay) {
    if ((performance.now() - this.waiting) / 1000 > LONG) {
      this.worker.terminate();
      this.worker = this.renew();
    }
    this.waiting = Infinity;
    this.autoplay = play;
    this.pulled = false;
    this.setPlaying(false);
    this.tell({type: 'open', run: ++this.run, endless: this.endless, ...sent});
  }

  /** The scene is there. */
  opened(facts) {
    this.looking = false;
    $('message').textContent = '';
    $('time').max = facts.duration;
  }

  startIfWanted() {
    if (this.autoplay) {
      this.start();
    }
  }

  setPlaying(on) {
    this.playing = on;
    if (!on) {
      this.paused();
    }
    this.showStart();
  }

  showStart() {
    const frame = this.frame;
    const again = !frame || frame.failure || frame.over && !this.looking || !frame.steps;
    $('start').textContent = this.playing ? TEXTS.pause : again ? TEXTS.elements.start : TEXTS.goOn;
  }

  start() {
    if (this.frame?.failure || this.frame?.over && !this.looking) {
      this.goOn(0);
    } else if (this.looking) {
      this.goOn(this.frame.time);
    } else {
      this.tell({type: 'play', speed: this.speed});
    }
    this.autoplay = false;
    this.setPlaying(true);
  }

  /** The worker computes the run anew up to this moment; pulls are not repeated, so what they changed is not kept. */
  goOn(time) {
    $('message').textContent = this.pulled && time > 0 ? TEXTS.withoutPulls : '';
    this.tell({type: 'goOn', time, speed: this.speed});
    if (this.pulled) {
      this.pulled = false;
      this.restarted();
    }
  }

  pause() {
    this.autoplay = false;
    this.tell({type: 'pause'});
    this.setPlaying(false);
  }

  startOrPause() {
    if (!$('start').disabled) {
      this.playing ? this.pause() : this.start();
    }
  }

  step() {
    if (!$('step').disabled) {
      this.pause();
      this.tell({type: 'step'});
    }
  }

  look(time) {
    this.autoplay = false;
    this.setPlaying(false);
    this.tell({type: 'look', time});
  }

  /** Back to the end of the step before. */
  stepBack() {
    if (this.frame) {
      this.look(this.frame.time * (1 - 1e-12));
    }
  }

  /** Pulls a particle towards a point, or lets it go; a pull sets a paused run going. */
  drag(id, point) {
    if (point && !this.playing && !this.frame?.over) {
      this.start();
    }
    this.pulled ||= Boolean(point);
    const pull = {type: 'drag', id: point ? id : '', point: point ?? [0, 0, 0]};
    this.tell(pull);
    return pull;
  }

  /** A moment of the run, in numbers. */
  show(frame) {
    this.frame = frame;
    this.looking = Boolean(frame.looking);
    $('time').max = Math.max($('time').max, frame.reached);
    $('time').value = frame.time;
    $('clock').textContent = few(frame.time) + ' s';
    $('steps').textContent = frame.steps;
    $('evaluations').textContent = frame.evaluations;
    $('seconds').textContent = this.looking ? '' : few(frame.seconds) + ' s';
    $('work').replaceChildren(...Object.entries(frame.work).filter(([name, joules]) => joules)
        .map(([name, joules]) => make('div', {textContent: name + ': ' + few(joules)})));
    if (frame.slowed || frame.failure && !this.looking) {
      $('message').textContent = frame.slowed ? TEXTS.slowed : frame.failure;
    }
    if (frame.over && !frame.failure && this.playing && $('atEnd').value === 'loop') {
      this.goOn(0);
    } else if (frame.over || frame.failure) {
      this.setPlaying(false);
    }
    this.waiting = this.playing ? performance.now() : Infinity;
    this.showStart();
  }

  /** The run cannot go on, only start anew. */
  fail(message) {
    if (this.frame) {
      this.frame.failure = message;
    }
    this.waiting = Infinity;
    this.setPlaying(false);
    $('message').textContent = TEXTS.internalError(message);
  }
}
