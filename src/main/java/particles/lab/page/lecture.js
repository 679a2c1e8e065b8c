// A lecture: the slides in their order, each with a scene that runs, a question, large type and few controls.
import {$} from './dom.js';

const STATIONS = JSON.parse($('stations').textContent);

export class Lecture {
  /**
   * describe(): the state of the page; open(state): goes to one; ended(): a lecture that a link began is over
   */
  constructor(describe, open, ended) {
    Object.assign(this, {describe, open, ended, slide: -1});
    $('slides').append(...STATIONS.map(({slide}, i) => new Option(slide, i)));
    $('slides').onchange = () => {
      $('slides').blur();               // the keys are for the lecture again
      this.go(Number($('slides').value));
    };
    $('previousSlide').onclick = () => this.turn(-1);
    $('nextSlide').onclick = () => this.turn(1);
    $('startLecture').onclick = $('endLecture').onclick = () => this.toggle();
  }

  get on() {
    return this.slide >= 0;
  }

  /** Begins, or ends with what the page showed before: the browser keeps that also when the page is loaded again. */
  toggle() {
    if (!this.on) {
      history.replaceState(this.describe(), '');
      this.go(0);
    } else if (history.state) {
      this.open(history.state);
    } else {                            // a link began the lecture
      this.show(-1);
      this.ended();
    }
  }

  /** So many slides on; the first and the last stay. */
  turn(by) {
    const to = Math.max(0, Math.min(STATIONS.length - 1, this.slide + by));
    to === this.slide || this.go(to);
  }

  go(slide) {
    this.open({...STATIONS[slide], scene: STATIONS[slide].scene + '.yaml', lecture: slide});
  }

  /** Shows a slide's words, whatever its scene does; -1 ends the lecture, and so does what is no number of a slide. */
  show(slide) {
    this.slide = STATIONS[slide] ? slide : -1;
    document.body.classList.toggle('lecture', this.on);
    $('lecture').hidden = !this.on;
    if (this.on) {
      $('endLecture').textContent = history.state ? TEXTS.backToScene : TEXTS.elements.endLecture;
      $('slides').value = slide;
      $('ask').textContent = STATIONS[slide].ask;
      $('previousSlide').disabled = slide === 0;
      $('nextSlide').disabled = slide === STATIONS.length - 1;
    } else {
      history.replaceState(null, '');
    }
  }
}
