// The page is one file, opened without a server: its modules import each other by addresses that are made here.
{
  const urls = new Map();
  for (const element of document.querySelectorAll('script.module')) {
    const text = element.textContent.replace(/(from\s*)(["'])([^"']+)\2/g,
        (all, from, quote, name) => urls.has(name) ? from + quote + urls.get(name) + quote : all);
    urls.set(element.dataset.name, URL.createObjectURL(new Blob([text], {type: 'text/javascript'})));
  }
  import(urls.get('./main.js'));
}
