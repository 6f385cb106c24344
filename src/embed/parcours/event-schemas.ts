/** The fields of every event and of every answer: for the manual, and to check the page's messages in tests. */
import * as v from 'valibot';

import { LANGUAGES } from '#core/languages';

import { SPEEDS } from '#simulation/pace';
import { ARENA_MODES, PARTS } from '../simulator';
import { flag, numberOf, poseFields, THEMES } from './schema-parts';
import type { CommandName, EventName, Events } from './protocol';
import { verdictSchema } from './verdict-schema';

const { pipe, description } = v;
const text = (about: string) => pipe(v.string(), description(about));
const texts = (about: string) => pipe(v.array(v.string()), description(about));
const nothing = v.strictObject({});
const record = <S extends v.GenericSchema>(value: S, about: string) =>
  pipe(v.record(v.string(), value), description(about));

const PHASES = ['ready', 'starting', 'running', 'paused', 'stopping', 'stopped', 'killed', 'failed'] as const;
const ENDS = ['finished', 'exception', 'panic', 'stopped', 'stuck'] as const;

const phase = pipe(
  v.picklist(PHASES),
  description('State of the run. `stopped`: the last picture stays. `killed`: ended by force.'),
);
const atMs = numberOf('Simulated time of the run, in ms.');
const colour = v.strictTuple([v.number(), v.number(), v.number()]);
const colours = (about: string) => pipe(v.array(colour), description(about));

const ALGORITHMS = ['face', 'track', 'object', 'line', 'colour', 'tag', 'classify'] as const;
const COLOUR_NAMES = ['red', 'orange', 'yellow', 'green', 'blue', 'purple', 'brown', 'white', 'gray', 'black'] as const;
const place = v.strictTuple([v.number(), v.number()]);
const box = { x: v.number(), y: v.number(), width: v.number(), height: v.number() };
const inPicture = v.variant('kind', [
  v.strictObject({ kind: v.literal('block'), ...box, id: v.number() }),
  v.strictObject({ kind: v.literal('arrow'), tail: place, head: place, id: v.number() }),
]);
const colourSensor = v.strictObject({
  side: v.picklist(['down', 'ahead']),
  raw: pipe(v.strictTuple([v.number(), v.number(), v.number(), v.number()]), description('Clear, red, green and blue at gain 4 and 24 ms.')), // prettier-ignore
  hue: numberOf('Whole degrees, white-balanced.'),
  name: v.picklist(COLOUR_NAMES),
});
const camera = v.strictObject({
  algorithm: v.picklist(ALGORITHMS),
  seen: pipe(v.nullable(v.array(inPicture)), description('Its last answer, in px of its picture of 320 × 240; `null`: the program has not asked within half a second.')), // prettier-ignore
});
const display = text('Digits 0 … 9 per LED of the display, rows separated by colons.');
const robot = pipe(
  v.nullable(
    v.strictObject({
      type: text('Id of the robot type.'),
      ...poseFields,
      turnedDeg: numberOf('Rotation since the start, counter-clockwise positive, not wrapped.'),
      pathMm: numberOf('Length of the path.'),
      collisions: numberOf('Touches of walls and blocks.'),
      leds: v.strictObject({ left: v.number(), right: v.number() }),
      rgb: colours('Colour lights: red, green, blue, 0 … 255.'),
      lamps: pipe(v.array(v.union([v.number(), colour])), description('Colour lamps, left and right: the number of the colour (0 off, 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white), or the colour itself.')), // prettier-ignore
      servos: record(v.number(), 'Degrees by port.'),
      motors: v.strictObject({ left: v.number(), right: v.number() }),
      distanceMm: pipe(v.nullable(v.number()), description('Distance to what the distance sensor faces.')),
      lidarMm: pipe(v.nullable(v.array(v.nullable(v.number()))), description('Depths of the lidar’s cells row by row from the upper left; `null`: nothing in range, or no lidar.')), // prettier-ignore
      lineSensors: v.array(
        v.strictObject({ name: v.string(), bright: v.boolean(), reading: v.exactOptional(v.number()) }),
      ),
      colours: v.exactOptional(
        pipe(v.array(colourSensor), description('What its colour sensors see. Missing without any.')),
      ),
      camera: v.exactOptional(pipe(camera, description('What its camera finds. Missing without one.'))),
    }),
  ),
  description('`null` for the bare board.'),
);
const pose = v.strictObject(poseFields);

const device = {
  running: pipe(v.picklist(['program', 'world']), description('`world`: the program has ended, and the world goes on.')), // prettier-ignore
  repl: flag('The REPL has greeted.'),
  board: text('Id of the board.'),
  display,
  buttons: v.strictObject({ a: v.boolean(), b: v.boolean() }),
  touch: record(v.boolean(), 'Whether each pad is touched.'),
  sensors: record(v.union([v.number(), v.string()]), 'Value of every sensor, by id.'),
  rgb: colours('Colour LEDs of the board itself.'),
  motors: pipe(v.array(v.number()), description('Duty of its own motor outputs, −1 … 1.')),
  soundHz: pipe(v.nullable(v.number()), description('Frequency of the present tone.')),
  robot,
  lights: pipe(v.array(v.strictObject({ pin: v.string(), colors: v.array(colour) })), description('Chains of colour lights on free pins.')), // prettier-ignore
};
const snapshot = v.strictObject({
  atMs,
  ...device,
  blocks: record(pose, 'Where the movable blocks are, by id.'),
  movers: record(pose, 'Where the moving obstacles are, by id.'),
  verdict: verdictSchema,
  others: v.exactOptional(
    pipe(
      v.array(v.strictObject({ name: v.string(), ...device })),
      description('The further microcomputers, where there are several: all else is the first one’s.'),
    ),
  ),
});

const fromDevice = {
  device: v.exactOptional(text('Name of a further microcomputer from which it comes. Left out: the first.')),
};

const packet = v.union([
  v.strictObject({ atMs, text: text('What `radio.send` sent.') }),
  v.strictObject({ atMs, bytes: pipe(v.array(v.number()), description('What `radio.send_bytes` sent.')) }),
]);
const logEvent = v.variant('type', [
  v.strictObject({ atMs, type: v.literal('row'), headings: v.array(v.string()), values: v.array(v.string()) }),
  v.strictObject({ atMs, type: v.literal('clear') }),
  v.strictObject({ atMs, type: v.literal('full') }),
]);

const robotChoice = {
  robot: text('Id of a robot type, `none` or `auto`.'),
  robotOptions: record(v.record(v.string(), v.string()), 'Robot → option → choice.'),
  device: text('Id of a microcomputer, or `auto`.'),
  firmware: text('Id of its firmware. Empty: the usual one.'),
};
const pageSettings = {
  language: v.picklist(LANGUAGES),
  theme: v.picklist(THEMES),
  muted: v.boolean(),
  parts: v.array(v.picklist(PARTS)),
};
const runSettings = {
  speed: v.picklist(SPEEDS),
  seed: v.number(),
  reality: v.number(),
  arenaSenses: v.boolean(),
};
const shown = pipe(
  v.strictObject({
    type: v.string(),
    text: v.string(),
    parts: v.exactOptional(v.array(v.strictObject({ name: v.string(), value: v.looseObject({}) }))),
    more: v.exactOptional(v.number()),
  }),
  v.metadata({ shown: 'value' }),
);
const breakPoint = { file: text('A file of the program.'), line: numberOf('Counted from 1.') };
const breakPoints = pipe(v.array(v.strictObject(breakPoint)), description('All of the program.'));
const position = v.strictObject({
  atMs: numberOf('Simulated time of the device, in ms.'),
  file: pipe(v.nullable(v.string()), description('File of the innermost of the program’s own functions; `null`: none runs.')), // prettier-ignore
  line: pipe(v.nullable(v.number()), description('Line in which it stands.')),
  stack: pipe(
    v.array(
      v.strictObject({
        function: text('Name, or `<module>` for a file.'),
        file: v.string(),
        line: v.number(),
        locals: record(shown, 'Its variables by name: `type`, `text` (as `repr` gives it, shortened), `parts` (`name`, `value`), and the number of parts that are left out, `more`.'), // prettier-ignore
      }),
    ),
    description('The program’s own functions that run, innermost first.'),
  ),
  globals: record(shown, 'The names that its file has made itself; in the same form.'),
});
const message = text('One English sentence.');
const omitted = (what: string) =>
  v.exactOptional(pipe(v.number(), description(`Number of ${what} that came too fast and are left out.`)));

/** Fields of every event, by its name. */
export const eventSchemas = {
  phase: v.strictObject({ phase }),
  started: nothing,
  'program-restarted': v.strictObject(fromDevice),
  ended: v.strictObject({
    ...fromDevice,
    ended: pipe(v.picklist(ENDS), description('`panic`: the board itself stopped; `stuck`: ended by force.')),
    exception: pipe(
      v.nullable(
        v.strictObject({
          type: v.string(),
          message: v.string(),
          line: v.nullable(v.number()),
          traceback: v.string(),
        }),
      ),
      description('The exception that ended the program.'),
    ),
    atMs,
    robot,
    display,
    verdict: verdictSchema,
  }),
  output: v.strictObject({
    ...fromDevice,
    text: text('Lines may end in `\\n` or `\\r\\n`.'),
    omitted: omitted('characters before this text'),
  }),
  snapshot: v.strictObject({ snapshot: pipe(snapshot, description('The run at one moment.')) }),
  held: v.strictObject({ ...fromDevice, atMs: numberOf('Simulated time of the device, in ms.'), ...breakPoint }),
  looking: v.strictObject({ atMs: pipe(v.nullable(v.number()), description('Its simulated time, in ms; `null`: the present is shown again.')) }), // prettier-ignore
  'break-points-changed': v.strictObject({ ...fromDevice, points: breakPoints }),
  'scene-changed': v.strictObject({ name: text('Name of the course.'), objects: numberOf('Number of its objects.') }),
  'files-changed': v.strictObject({ ...fromDevice, names: texts('Names of all files.') }),
  'settings-changed': v.strictObject({
    settings: v.strictObject({ ...pageSettings, ...robotChoice, ...runSettings }),
  }),
  sensed: v.strictObject({
    ...fromDevice,
    sensor: text('Id of the sensor: `buttonA`, `pinLogo`, `lightLevel`, …'),
    value: pipe(v.union([v.number(), v.string()]), description('1 and 0 for buttons and pads.')),
  }),
  radio: v.strictObject({ ...fromDevice, packets: v.array(packet), omitted: omitted('packets before these') }),
  log: v.strictObject({ ...fromDevice, events: v.array(logEvent), omitted: omitted('rows before these') }),
  refused: v.strictObject({ message }),
  failed: v.strictObject({ message }),
} satisfies { readonly [N in EventName]: v.GenericSchema<unknown, Events[N]> };

/** All names of events, in the order of the manual. */
export const eventNames = Object.keys(eventSchemas) as unknown as readonly [EventName, ...EventName[]];

const file = v.strictObject({ name: v.string(), text: v.string() });
const fileValue = (shown: string) => pipe(v.looseObject({ format: v.string(), version: v.number() }), v.metadata({ shown })); // prettier-ignore

const welcome = v.strictObject({
  versions: pipe(v.array(v.number()), description('Versions of this dialect that the page speaks.')),
  app: text('Version of the app.'),
  page: text('Changes with every load of the page.'),
  abilities: v.strictObject({
    commands: texts('All commands.'),
    events: texts('All events.'),
    devices: texts('Ids of the microcomputers.'),
    robots: texts('Ids of the robots.'),
    courses: texts('Ids of the ready courses.'),
    languages: texts('Languages of the page.'),
    speeds: v.array(v.picklist(SPEEDS)),
    parts: texts('Parts of the page.'),
    limits: record(v.number(), 'Limits of this dialect.'),
  }),
});

const state = v.strictObject({
  phase,
  atMs,
  devices: v.exactOptional(texts('Names of the microcomputers, the first one’s first, where there are several.')),
  board: text('Id of the board of the next run.'),
  ended: pipe(v.nullable(v.picklist(ENDS)), description('`null` before and while the program runs.')),
  snapshot: pipe(
    v.nullable(snapshot),
    v.metadata({ shown: 'object or `null`' }),
    description('As in the event `snapshot`; `null` before the first run.'),
  ),
  mode: pipe(v.exactOptional(v.picklist(ARENA_MODES)), description('The mode of the arena.')),
  looking: pipe(v.exactOptional(v.boolean()), description('A moment of the past is shown: `atMs` and `snapshot` are that moment’s.')), // prettier-ignore
  sensors: record(v.number(), 'Values that hold for every run.'),
  ...runSettings,
});

/** Fields of the answers that contain more than success. */
export const answerSchemas = {
  hello: welcome,
  state,
  'get-break-points': v.strictObject({ points: breakPoints }),
  'get-position': position,
  'get-project': v.strictObject({ project: fileValue('project file') }),
  'get-files': v.strictObject({ files: v.array(file) }),
  'get-scene': v.strictObject({ scene: fileValue('course file') }),
  'get-robot': v.strictObject(robotChoice),
  'get-settings': v.strictObject(pageSettings),
} satisfies Partial<{ readonly [N in CommandName]: v.GenericSchema }>;
