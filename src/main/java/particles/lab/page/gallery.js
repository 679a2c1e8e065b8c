// The scenes to choose from: a list and, in a window of its own, their pictures with titles.
import {$, make} from './dom.js';

const titleOf = scene => /^title: *(.*)/m.exec(scene.textContent)?.[1] ?? scene.dataset.name;

export class Gallery {
  /** scenes: the page's elements with their texts; chosen(name): called when somebody has chosen one */
  constructor(scenes, chosen) {
    const short = scene => scene.dataset.name.replace(/\.yaml$/, '');
    $('scene').append(...scenes.map(scene => new Option(short(scene), scene.dataset.name)));
    $('scene').onchange = () => chosen($('scene').value);
    $('pictures').append(...scenes.map(scene => {
      const button = make('button'), picture = new Image(320, 180);
      picture.alt = '';
      picture.src = scene.dataset.picture ? 'data:image/jpeg;base64,' + scene.dataset.picture : 'data:,';
      picture.hidden = !scene.dataset.picture;
      button.append(picture, [/^\d+/.exec(short(scene)), titleOf(scene)].join(' '));
      button.onclick = () => {
        $('gallery').close();
        $('scene').value = scene.dataset.name;
        chosen(scene.dataset.name);
      };
      return button;
    }));
    $('showGallery').onclick = () => $('gallery').showModal();
    $('closeGallery').onclick = () => $('gallery').close();
  }
}
