// Runs as soon as the engine is here: its worker compiles it while the page is read and its modules are compiled.
{
  // It unpacks itself; what it is asked before that waits.
  const engine = URL.createObjectURL(new Blob([`{
    const early = [];
    onmessage = event => early.push(event);
    fetch('data:;base64,${document.getElementById('engine').textContent}')
      .then(({body}) => new Response(body.pipeThrough(new DecompressionStream('deflate'))).text())
      .then(text => (0, eval)(text))    // importScripts waits for the page's thread
      .catch(error => { onmessage = () => postMessage({type: 'broken', message: String(error)}); })
      .then(() => early.forEach(message => onmessage(message)));
  }`], {type: 'text/javascript'}));
  window.started = {engine, worker: new Worker(engine)};
}
