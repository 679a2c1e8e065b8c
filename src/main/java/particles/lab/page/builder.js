// Building with the mouse: what is done to the picture is written into the scene's text, which is then opened anew.
import {$} from './dom.js';

export class Builder {
  /**
   * view: the picture; hand: what people do on it, with a builder while they build; phase: knows the chosen particle;
   * edit(how, ...what): changes the text; begin(): shows the run's start; tell(text): says something to the person
   */
  constructor(view, hand, phase, edit, begin, tell) {
    Object.assign(this, {view, hand, phase, edit, begin});
    $('build').onclick = () => this.turn(!hand.builder);
    for (const change of ['toggleFixed', 'remove']) {
      $(change).onclick = () => phase.id.endsWith(']')
          ? tell(TEXTS.ofShape(phase.id)) : phase.id && edit(change, phase.id);
    }
  }

  turn(on) {
    this.hand.builder = on ? this : null;
    $('build').setAttribute('aria-pressed', on);
    $('building').hidden = !on;
    this.show();
    on && this.begin();
  }

  /** Marks the chosen particle. */
  show() {
    this.view.choose(this.hand.builder && this.phase.id);
  }

  place(event) {
    const digits = Math.max(0, Math.round(2.7 - Math.log10(this.view.camera.seenHeight())));
    this.edit('place', ...this.view.pointInPlane(event).map(x => Number(x.toFixed(digits))));
  }

  join(from, to) {
    to && to !== from && this.edit('join', from, to, Boolean($('between').value));
  }
}
