// The page is one file, opened without a server: its modules import each other by addresses that are made here. While
// they are compiled, the engine opens the scene that comes first.
{
  if (!location.hash) {
    const {dataset: {name, first}, textContent} = document.querySelector('script.scene[data-first]');
    window.started.opening = {type: 'open', run: 1, file: name, text: textContent, solver: first, deltaT: '',
      tolerance: 0};
    window.started.worker.postMessage(window.started.opening);
  }
  const urls = new Map();
  for (const element of document.querySelectorAll('script.module')) {
    const text = element.textContent.replace(/(from\s*)(["'])([^"']+)\2/g,
        (all, from, quote, name) => urls.has(name) ? from + quote + urls.get(name) + quote : all);
    urls.set(element.dataset.name, URL.createObjectURL(new Blob([text], {type: 'text/javascript'})));
  }
  import(urls.get('./main.js'));
}
