/** The permitted imports: each room of `src/` and the rooms it may reach. Enforced by `npm run check`. */
export const layers = {
  core: [],
  board: ['core'],
  vm: ['core', 'board'],
  devices: ['core', 'board'],
  world: ['core'],
  attachments: ['core', 'world', 'devices'],
  robots: ['core', 'board', 'devices', 'world', 'attachments', 'reference'],
  scene: ['core'],
  picture: ['core', 'scene'],
  'my-robot': ['core', 'board', 'robots', 'scene', 'simulation'],
  project: ['core', 'scene', 'my-robot'],
  editor: ['core', 'scene'],
  simulation: ['core', 'board', 'vm', 'devices', 'world', 'attachments', 'robots', 'libraries', 'scene'],
  tape: ['core', 'scene', 'vm', 'simulation'],
  python: [],
  advice: ['core', 'robots'],
  catalogue: ['core', 'scene', 'project'],
  check: ['core', 'board', 'scene', 'project', 'my-robot', 'simulation', 'tape', 'python', 'advice', 'picture'],
  lab: ['core', 'robots', 'scene', 'simulation', 'python', 'check'],
  hint: ['core', 'scene', 'project', 'simulation', 'python', 'check'],
  'school-class': ['core', 'scene', 'check'],
  intake: [
    'core',
    'board',
    'scene',
    'project',
    'my-robot',
    'simulation',
    'tape',
    'python',
    'advice',
    'check',
    'school-class',
    'hex',
  ],
  embed: ['core', 'board', 'vm', 'scene', 'project', 'simulation', 'python'],
  reference: ['core', 'python'],
  libraries: ['core', 'reference'],
  hex: ['core', 'board', 'robots', 'project', 'python', 'libraries'],
  'device-check': ['core', 'python', 'reference'],
  'device-log': [],
  cli: [
    'core', 'board', 'robots', 'scene', 'project', 'my-robot', 'vm', 'simulation', 'tape', 'python', 'device-check',
    'check', 'lab', 'hint', 'school-class', 'intake', 'hex', 'catalogue', 'advice',
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
    'picture',
    'project',
    'my-robot',
    'editor',
    'simulation',
    'tape',
    'embed',
    'python',
    'advice',
    'reference',
    'device-check',
    'device-log',
    'check',
    'lab',
    'school-class',
    'intake',
    'hex',
    'catalogue',
  ],
};

/**
 * The same for the page. Its rooms stand in wings, from the floor of controls to the app that joins all: a room reaches other
 * rooms of its wing and of wings before it, as its row says, and never a wing behind it. All reach the kit.
 */
export const wings = {
  kit: null,
  session: {
    run: [],
    work: ['session/run'],
    visit: ['session/run', 'session/work'],
    mode: ['session/run', 'session/work', 'session/visit'],
    layout: ['session/run', 'session/work', 'session/visit', 'session/mode'],
    task: ['session/run', 'session/work', 'session/layout'],
    models: ['session/run', 'session/work', 'session/visit', 'session/layout', 'session/task', 'session/mode'],
  },
  course: { editor: ['session'] },
  pupil: {
    debug: ['session'],
    why: ['session', 'pupil/debug'],
    console: ['session', 'pupil/debug', 'pupil/why'],
    'look-back': ['session', 'pupil/console'],
    chart: ['session', 'pupil/console', 'pupil/look-back'],
    'device-log': ['session'],
    board: ['session', 'pupil/device-log', 'pupil/debug'],
    narration: ['session', 'course/editor'],
    'several-devices': ['session', 'pupil/board'],
    'next-step': ['session', 'course/editor', 'pupil/console'],
    arena: [
      'session', 'course/editor', 'pupil/console', 'pupil/board', 'pupil/narration', 'pupil/several-devices', 'pupil/look-back',
      'pupil/next-step',
    ], // prettier-ignore
    code: ['session', 'pupil/console', 'pupil/board', 'pupil/several-devices', 'pupil/debug'],
    locks: ['session', 'course/editor', 'pupil/code'],
    device: ['session', 'pupil/arena', 'pupil/several-devices'],
    galleries: ['session', 'pupil/device'],
    works: ['session', 'pupil/galleries'],
    'real-device': ['session'],
    'my-robot': ['session', 'pupil/device', 'pupil/galleries', 'pupil/real-device'],
  },
  exchange: {
    elsewhere: ['session', 'pupil/console'],
    share: ['session', 'course/editor', 'pupil/console', 'pupil/device-log', 'exchange/elsewhere'],
    offline: [],
    host: ['session', 'course/editor', 'pupil/board', 'pupil/console', 'pupil/debug', 'exchange/share'],
  },
  teacher: {
    projector: ['session', 'pupil/console', 'pupil/arena', 'pupil/next-step'],
    print: ['session', 'course/editor', 'pupil/arena', 'pupil/look-back', 'exchange/share'],
    desk: ['session', 'pupil/galleries'],
    class: ['session', 'pupil/galleries', 'exchange/share', 'teacher/desk'],
    classes: ['session', 'pupil/galleries', 'teacher/class', 'teacher/desk'],
    'task-maker': [
      'session', 'course/editor', 'pupil/code', 'pupil/locks', 'pupil/galleries', 'pupil/board', 'exchange/share',
      'teacher/class', 'teacher/print', 'teacher/desk', 'teacher/shelf',
    ], // prettier-ignore
    shelf: ['session'],
    series: ['session', 'pupil/galleries', 'exchange/share', 'teacher/desk', 'teacher/shelf'],
    'my-tasks': ['session', 'pupil/galleries', 'exchange/share', 'teacher/desk', 'teacher/series', 'teacher/shelf'],
  },
  help: ['session', 'course/editor', 'pupil/galleries', 'teacher/desk'],
  app: ['session'],
};

/** The rows of the page's rooms by the folder below `src/web/`: what each may import, rooms or whole wings. */
export const webLayers = Object.fromEntries(
  Object.entries(wings).flatMap(([wing, rooms]) =>
    rooms === null || Array.isArray(rooms)
      ? [[wing, rooms === null ? [] : ['kit', ...rooms]]]
      : Object.entries(rooms).map(([room, allowed]) => [`${wing}/${room}`, ['kit', ...allowed]]),
  ),
);
