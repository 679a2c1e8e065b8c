// The page's texts, all in one place for a second language. Other words come from scenes, slides and the engine.
const TEXTS = {
  // in the elements with these ids, in a label around a field, or in the term before a description
  elements: {scene: 'Scene', showGallery: 'Pictures of scenes', startLecture: 'Lecture', copyLink: 'Copy link',
    showEditor: 'Scene file', slides: 'Slide', endLecture: 'End', closeGallery: 'Close', time: 'Time', start: 'Start',
    step: 'One step', restart: 'From the start', speed: 'Speed', atEnd: 'At the end', build: 'Build',
    toggleFixed: 'Fix or free', remove: 'Delete', undo: 'Undo', between: 'From mass to mass',
    buildingHelp: 'Click to place or choose a mass; drag from one to another to join them. Without a mouse, edit the'
      + ' scene file.', fullScreen: 'Full screen',
    arrows: 'velocities', forces: 'forces', labels: 'names', saving: 'Save picture, plots, table or film',
    savePicture: 'Picture', saveEnergy: 'Energy plot', savePhase: 'Phase plot', saveTable: 'Table (CSV)', film: 'Film',
    steps: 'Steps', evaluations: 'Evaluations', pace: 'Simulated time per second', seconds: 'CPU time',
    solver: 'Solver', deltaTNumber: 'Time step deltaT (s)', stabilityName: 'Stability region',
    regionHelp: 'h is deltaT; λ, of the springs\' stiffest vibration, is estimated from above. The method is stable'
      + ' where it is coloured.', tolerance: 'Relative tolerance', set: 'Other values for keys of the scene',
    parametersName: 'Numbers of the scene', equationsName: 'Equations', energyName: 'Energy',
    logarithmic: 'numerical error on a logarithmic axis', curvesName: 'Curves', particle: 'Particle', vertical: 'Plot',
    horizontal: 'over', addCurve: 'Add another', oneCurve: 'Only this one',
    ghost: 'Wide grey line: the reference, dormand-prince with tolerance 1e-10.', mass: 'Mass',
    place: 'Position', velocity: 'Velocity', forceList: 'Forces on it', work: 'Work since the start (J)',
    compareName: 'Compare', addPanel: 'Add a run', equalWork: 'At equal',
    nearestName: 'Distance from the reference',
    distancesHelp: 'Root mean squares over all particles, at 201 times, without pulls.', editorName: 'Scene file',
    textOf: 'of', save: 'Save', open: 'Open', licences: 'Licences of the software in this page'},
  choices: {speed: {'1/10': 0.1, '1/4': 0.25, '1/2': 0.5, 'real time': 1, '2 times': 2, '5 times': 5},
    atEnd: {'go on': 'on', 'begin again': 'loop', stop: 'stop'}, between: {'a spring': '', 'a muscle': 'muscle'},
    tolerance: {'the scene\'s': 0},
    equalWork: {'time, each with its deltaT': '', 'work: as many evaluations per simulated second': 'on'}},
  ariaLabel: {lecture: 'Lecture', previousSlide: 'Previous slide', nextSlide: 'Next slide', gallery: 'Scenes',
    picture: 'The scene', view: 'The scene in three dimensions', settings: 'Solver and time step',
    deltaT: 'deltaT in seconds', equations: 'Equations', energy: 'Plot of the energies over time',
    phase: 'Plot of one quantity over another', distances: 'Plot of the distances'},
  title: {startLecture: 'L', endLecture: 'L', previousSlide: 'Page Up', nextSlide: 'Page Down', fullScreen: 'F'},
  placeholder: {set: 'springs[0].damping=20, duration=5'},

  noWebGL: 'No picture: this browser has no WebGL 2. Plots, numbers and the editor work.',
  internalError: message => 'Internal error; please report it: ' + message,

  // the run
  pause: 'Pause', goOn: 'Continue',
  run: number => 'run ' + number,
  caption: (solver, deltaT) => `${solver}, deltaT = ${deltaT} s`,
  moment: (time, evaluations) => `: ${time} s, ${evaluations} evaluations`,
  errors: count => 'The scene has ' + (count === 1 ? 'an error' : count + ' errors') + '; see below its text.',
  recorded: (caption, stopped) => 'A recorded run: ' + caption + (stopped && '; ' + stopped) + '.',
  slowed: 'This run fails. Its last steps, slowed down:',
  withoutPulls: 'The run up to this moment was computed anew, without your earlier pulls.',
  longStep: seconds => `A step is being computed, for ${seconds} s now`,
  longSteps: (count, seconds) => `; the ${count} before took ${seconds} s each.`,

  ofShape: id => id + ' is one of a shape; the scene file says which of them are fixed.',

  // solver and time step
  ownSolver: 'A solver of your own.',
  seconds: deltaT => deltaT + ' seconds',
  longerThanScene: duration => `Longer than the scene: one step of ${duration} s.`,
  ownSteps: 'Chooses its own steps, at most deltaT long.',
  unstable: 'Undamped springs gain energy at any deltaT.',
  stable: limit => `Stable at least up to ${limit} s for the springs of this scene.`,
  unlimited: 'No spring limits deltaT here.',
  grows: factor => `: each step multiplies this vibration by ${factor}, so it grows.`,
  decays: factor => `: each step multiplies this vibration by ${factor}, so it decays.`,
  keepsSize: ': each step keeps its size.',
  untried: (solver, message) => solver + ' cannot be tried: ' + message,
  coloured: 'coloured: stable', computing: 'The region is being computed ...', outside: 'outside the picture',

  // numbers of the scene
  places: {'another place': '', Earth: 9.81, Moon: 1.62, Jupiter: 24.79, 'no gravity': 0},       // m/s^2
  gravityOf: 'Gravity of',
  several: (owner, count) => owner + ', ' + count + ' of them',
  span: numbers => numbers.join(' to '),

  // plots
  time: 'time', speedName: 'speed', timeAxis: 'time (s)', energyAxis: 'energy (J)', errorAxis: 'error (J)',
  distanceAxis: 'distance (m)', reference: 'reference', marks: 'marks', distanceTo: other => 'distance to ' + other,
  noParticle: 'none yet',
  fromLowest: name => name + ' (from its lowest)',
  of: (quantity, particle) => quantity + ' of ' + particle,
  period: (period, amplitude) => `Between the last two maxima: period ${period} s, amplitude ` + amplitude,

  // runs beside each other
  sceneOf: run => 'The scene of ' + run, solverOf: run => 'Solver of ' + run, itsStep: 'Its deltaT (s)',
  remove: 'Remove', ownText: ', own text',
  noCost: 'No fixed number of evaluations per step, so its own deltaT.',
  meanDistances: (time, runs) => `Mean distance over ${time} s: ${runs.join(', ')}. `,
  stops: name => name + ' stops',
  left: 'All have left the reference.', noDifference: 'No difference that the reference can tell.',
  notClear: 'No clear difference.',
  nearest: (name, factor, next) => 'Nearest: ' + name + (factor && `; ${next} is ${factor} times as far`) + '.',
  named: (solver, run) => `${solver} (${run})`,
  parted: metres => ' References with tolerances 1e-10 and 1e-9 end ' + metres
    + ' m apart: this motion magnifies small errors.',

  // links and files
  address: 'The part of the address after #',
  damaged: name => name + ' is damaged or incomplete, so nothing could be opened from it.',
  tooLong: 'This scene is too long for a link.', copied: 'The link is in the clipboard.',
  notCopied: 'The link is in the address bar; copy it there.',
  saveState: 'Save lab.json', toEmbed: 'To embed:',
  local: 'This page is a file, so links work on this machine alone.',
  sendFile: 'Send a file instead, which "Open" above the scene\'s text opens:',
  noFilms: 'This browser cannot record films.', endFilm: 'End the film',
  recording: 'Recording: "End the film" saves it.',
  backToScene: 'End, back to my scene'
};

for (const [id, text] of Object.entries(TEXTS.elements)) {
  const element = document.getElementById(id);
  const tag = {SELECT: 'label', INPUT: 'label', DD: 'dt'}[element.tagName];
  const named = tag ? document.createElement(tag) : element;
  if (tag) {
    named.className = element.className;
    element.before(named);
    tag === 'label' && named.append(element);
  }
  element.type === 'checkbox' ? named.append(' ' + text) : named.prepend(text + ' ');
}
for (const property of ['ariaLabel', 'title', 'placeholder']) {
  Object.entries(TEXTS[property]).forEach(([id, text]) => { document.getElementById(id)[property] = text; });
}
for (const [id, values] of Object.entries(TEXTS.choices)) {
  document.getElementById(id).append(...Object.entries(values).map(([text, value]) => new Option(text, value)));
}
