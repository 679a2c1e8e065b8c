// Runs as soon as the engine is here: it starts in its worker while the page is read and its modules are compiled.
{
  // It unpacks itself; what it is asked before that waits.
  const engine = URL.createObjectURL(new Blob([`{
    const early = [];
    onmessage = event => early.push(event);
    fetch('data:;base64,${document.getElementById('engine').textContent}')
      .then(({body}) => new Response(body.pipeThrough(new DecompressionStream('deflate'))).text())
      .then(text => {
        (0, eval)(text);                // importScripts waits for the page's thread
        early.forEach(onmessage);
      })
      .catch(error => postMessage({type: 'broken', message: String(error)}));
  }`], {type: 'text/javascript'}));
  const worker = new Worker(engine), told = [];
  worker.onmessage = event => told.push(event);
  worker.postMessage({type: 'solvers'});
  window.started = {engine, worker, told, opening: null};
}
