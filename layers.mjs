/** Who may import whom: each room of `src/` and the rooms it may reach. Enforced by `npm run check`. */
export const layers = {
  core: [],
  board: ['core'],
  vm: ['core', 'board'],
  devices: ['core', 'board'],
  world: ['core'],
  attachments: ['core', 'world', 'devices'],
  robots: ['core', 'board', 'devices', 'world', 'attachments', 'reference'],
  scene: ['core'],
  'my-robot': ['core', 'board', 'robots', 'scene', 'simulation'],
  project: ['core', 'scene', 'my-robot'],
  editor: ['core', 'scene'],
  simulation: ['core', 'board', 'vm', 'devices', 'world', 'attachments', 'robots', 'libraries', 'scene'],
  tape: ['core', 'scene', 'vm', 'simulation'],
  python: [],
  check: ['core', 'board', 'scene', 'project', 'my-robot', 'simulation', 'tape', 'python'],
  embed: ['core', 'board', 'scene', 'project', 'simulation', 'python'],
  reference: ['core', 'python'],
  libraries: ['core', 'reference'],
  'device-check': ['core', 'python', 'reference'],
  'device-log': [],
  cli: [
    'core', 'board', 'robots', 'scene', 'project', 'my-robot', 'vm', 'simulation', 'tape', 'python', 'device-check',
    'check',
  ], // prettier-ignore
  web: [
    'core',
    'board',
    'vm',
    'devices',
    'world',
    'attachments',
    'robots',
    'libraries',
    'scene',
    'project',
    'my-robot',
    'editor',
    'simulation',
    'tape',
    'embed',
    'python',
    'reference',
    'device-check',
    'device-log',
  ],
};

/**
 * The same for the rooms of the page: each folder of `src/web/`, from the floor of helpers to the app that knows all, and
 * the rooms it may reach.
 */
export const webLayers = {
  page: [],
  run: ['page'],
  work: ['page', 'run'],
  visit: ['page', 'run', 'work'],
  layout: ['page', 'work', 'visit'],
  task: ['page', 'run', 'work', 'layout'],
  console: ['page', 'run', 'work', 'layout'],
  'look-back': ['page', 'run', 'work', 'console'],
  chart: ['page', 'run', 'work', 'console', 'look-back'],
  'device-log': ['page', 'run', 'work'],
  board: ['page', 'run', 'work', 'visit', 'layout', 'device-log'],
  'course-editor': ['page', 'run', 'work', 'visit', 'layout', 'task'],
  narration: ['page', 'run', 'work', 'course-editor'],
  arena: [
    'page', 'run', 'work', 'visit', 'layout', 'task', 'console', 'board', 'course-editor', 'narration', 'several-devices',
    'look-back',
  ], // prettier-ignore
  'several-devices': ['page', 'run', 'work', 'board'],
  code: ['page', 'run', 'work', 'visit', 'layout', 'console', 'several-devices'],
  device: ['page', 'run', 'work', 'layout', 'arena'],
  galleries: ['page', 'run', 'work', 'layout', 'task', 'device'],
  print: ['page', 'run', 'work', 'task', 'arena'],
  share: ['page', 'run', 'work', 'visit', 'device-log'],
  'first-steps': ['page', 'run', 'work', 'layout', 'task', 'console', 'course-editor', 'code', 'device', 'share'],
  'real-device': ['page', 'work'],
  'my-robot': ['page', 'run', 'work', 'layout', 'device', 'galleries', 'real-device'],
  offline: ['page'],
  host: ['page', 'run', 'work', 'visit', 'layout', 'console', 'board', 'course-editor', 'share'],
  app: [
    'page', 'run', 'work', 'visit', 'layout', 'task', 'console', 'board', 'course-editor', 'narration', 'arena', 'code', 'device',
    'chart', 'galleries', 'print', 'share', 'first-steps', 'real-device', 'my-robot', 'device-log', 'several-devices', 'host',
  ], // prettier-ignore
};
