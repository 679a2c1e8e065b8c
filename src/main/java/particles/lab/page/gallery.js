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
      const {name, picture} = scene.dataset;
      return make('button', {onclick: () => {
        $('gallery').close();
        $('scene').value = name;
        chosen(name);
      }}, ...picture ? [make('img', {alt: '', width: 320, height: 180, src: 'data:image/jpeg;base64,' + picture})] : [],
          [/^\d+/.exec(short(scene)), titleOf(scene)].join(' '));
    }));
    $('showGallery').onclick = () => $('gallery').showModal();
    $('closeGallery').onclick = () => $('gallery').close();
  }
}
