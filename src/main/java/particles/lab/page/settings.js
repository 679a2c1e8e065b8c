// The solver, its time step and its tolerance: what is chosen beside the scene's text.
import {$, few} from './dom.js';
import {SOLVERS} from './opening.js';

export class Settings {
  /** changed(what): called with the settings that somebody has changed; stability: shows what deltaT does */
  constructor(changed, stability) {
    this.stability = stability;
    const slider = $('deltaT'), typed = $('deltaTNumber');
    $('solver').append(...SOLVERS.map(one => new Option(one.name)));
    $('tolerance').append(...['1e-3', '1e-4', '1e-6', '1e-8', '1e-10'].map(one => new Option(one, Number(one))));
    $('solver').onchange = () => changed({solver: $('solver').value, tolerance: 0});
    $('tolerance').onchange = () => changed({tolerance: Number($('tolerance').value)});
    typed.onchange = () => changed({deltaT: typed.value.trim()});
    $('set').onchange = () => changed({set: $('set').value});
    slider.oninput = () => {
      typed.value = few(10 ** slider.value, 2);
      this.showStability(Number(typed.value));
    };
    slider.onchange = () => changed({deltaT: typed.value});
  }

  show(facts, {tolerance, set}) {
    this.facts = facts;
    const solver = SOLVERS.find(one => one.name === facts.solver), limit = facts.limit;
    const slider = $('deltaT');
    $('solver').value = facts.solver;
    $('tolerance').value = tolerance;
    $('set').value = set;
    $('sentence').textContent = solver?.sentence ?? TEXTS.ownSolver;
    $('tolerance').hidden = !solver?.adaptive;
    $('deltaTNumber').value = facts.deltaT;
    slider.value = Math.log10(facts.deltaT);
    slider.setAttribute('aria-valuetext', TEXTS.seconds(facts.deltaT));
    const part = limit > 0 ? (Math.log10(limit) - slider.min) / (slider.max - slider.min) : -1;
    $('mark').hidden = !(part >= 0 && part <= 1);
    $('mark').style.left = `calc(${100 * part}% + ${8 - 16 * part}px)`;
    $('limit').textContent = facts.deltaT > facts.duration ? TEXTS.longerThanScene(few(facts.duration))
        : solver?.adaptive ? TEXTS.ownSteps : limit === 0 ? facts.damping ? '' : TEXTS.unstable
        : limit > 0 ? TEXTS.stable(few(limit)) : solver?.sentence ? TEXTS.unlimited : '';
    this.refuse([]);
    this.showStability(facts.deltaT);
  }

  showStability(deltaT) {
    this.stability.show(this.facts, deltaT);
  }

  /** Says beside each field why what was typed is not taken; the last valid deltaT is shown again. */
  refuse(lines) {
    const [wrong] = ['deltaT', 'set'].map(key => {
      const its = lines.filter(line => line.startsWith(key));
      $(key + 'Error').textContent = its.map(line => line.replace(/^\w+:? /, '')).join('\n');
      $(key === 'set' ? key : 'deltaTNumber').setAttribute('aria-invalid', its.length > 0);
      return its.length > 0;
    });
    if (wrong) {
      $('deltaTNumber').value = this.facts.deltaT;
      $('deltaT').value = Math.log10(this.facts.deltaT);
      this.showStability(this.facts.deltaT);
    }
  }
}
