/** The fields of every command, validated by valibot. An unknown field is refused: it is usually a typing mistake. */
import * as v from 'valibot';

import { LANGUAGES } from '#core/languages';
import { FILE_BYTES, NAME_CHARACTERS, projectLimits } from '#project/project';
import type { SceneEdit } from '#scene/edit';

import { ARENA_MODES, PARTS } from '../simulator';
import { eventNames } from './event-schemas';
import { limits } from './limits';
import type { CommandName, Commands, ProjectFile, SceneFile } from './protocol';
import { flag, idOf, poseFields, speed, STEPS, textOf, THEMES } from './schema-parts';

const { exactOptional: maybe, pipe, description } = v;

/** A value that is validated elsewhere, by the rules of files. */
const document = <T>(shown: string, about: string) =>
  pipe(
    v.custom<T>((value) => typeof value === 'string' || (typeof value === 'object' && value !== null)),
    v.metadata({ shown }),
    description(about),
  );

const nothing = v.strictObject({});
const smallMap = <S extends v.GenericSchema<unknown, unknown>>(value: S, most: number) =>
  pipe(v.record(idOf('An id.'), value), v.maxEntries(most));

const files = pipe(
  v.array(
    v.strictObject({
      name: pipe(textOf(NAME_CHARACTERS), v.minLength(1), description('Letters, digits, `_`, `-` and `.`.')),
      text: pipe(textOf(FILE_BYTES), description('At most 256 KiB in UTF-8.')),
    }),
  ),
  v.minLength(1),
  v.maxLength(projectLimits.files),
  description('All files of the program; `main.py` must be among them.'),
);

const robotOptions = pipe(
  smallMap(smallMap(idOf('Id of a choice.'), projectLimits.options), projectLimits.options),
  description('Id of the robot → id of the option → id of the choice.'),
);

const sensorValue = pipe(
  v.union([pipe(v.number(), v.finite()), textOf(limits.nameCharacters)]),
  description('A number within the range of the sensor; for `gesture` a word such as `shake`.'),
);

const ofDevice = {
  device: maybe(idOf('Name of the microcomputer, where the project has several. Left out: the first.')),
};
const toDevice = { device: maybe(idOf('Name of the microcomputer that receives it. Left out: all.')) };

const place = {
  file: pipe(textOf(NAME_CHARACTERS), v.minLength(1), description('A file of the program.')),
  line: pipe(v.number(), v.integer(), v.minValue(1), description('Counted from 1.')),
};

/** Fields of every command, by its name. */
export const commandSchemas = {
  hello: v.strictObject({
    session: maybe(pipe(textOf(limits.idCharacters), description('Any text. A second hello with the same text continues the same conversation.'))), // prettier-ignore
    client: maybe(pipe(textOf(limits.nameCharacters), description('Name of the host.'))),
    versions: maybe(pipe(v.array(v.number()), v.maxLength(20), description('Versions of this dialect that the host speaks.'))), // prettier-ignore
  }),
  bye: nothing,
  state: nothing,
  subscribe: v.strictObject({
    events: maybe(
      pipe(v.array(v.picklist(eventNames)), v.maxLength(eventNames.length), description('The events to send. Left out: as before. At first: all.')), // prettier-ignore
    ),
    snapshotHz: maybe(pipe(v.number(), v.minValue(0), v.maxValue(limits.snapshotHz), description('Snapshots per second. Left out: as before. At first: 0.'))), // prettier-ignore
  }),
  'get-project': nothing,
  'set-project': v.strictObject({
    project: document<ProjectFile | string>('project file', 'The file as text or as value. Its robot, microcomputer and seed are adopted.'), // prettier-ignore
  }),
  'get-files': v.strictObject(ofDevice),
  'set-files': v.strictObject({ files, ...ofDevice }),
  'get-scene': nothing,
  'set-scene': v.strictObject({ scene: document<SceneFile | string>('course file', 'The file as text or as value.') }),
  edit: v.strictObject({ edit: document<SceneEdit>('edit of a course', 'One step: see `src/scene/edit.ts`.') }),
  'get-robot': nothing,
  'set-robot': v.strictObject({
    robot: maybe(idOf('Id of a robot type, `none` for the bare board, or `auto` (the course or the program decides).')),
    robotOptions: maybe(robotOptions),
    device: maybe(idOf('Id of a microcomputer, or `auto`.')),
    firmware: maybe(idOf('Id of its firmware. Empty: the usual one.')),
  }),
  'get-settings': nothing,
  settings: v.strictObject({
    language: maybe(pipe(v.picklist(LANGUAGES), description('Of the whole page.'))),
    theme: maybe(pipe(v.picklist(THEMES), description('`system`: as set on the device.'))),
    muted: maybe(flag('Whether the board is silent.')),
    parts: maybe(pipe(v.array(v.picklist(PARTS)), v.minLength(1), v.maxLength(PARTS.length), description('The parts of the page that are shown.'))), // prettier-ignore
    labels: maybe(pipe(smallMap(textOf(limits.labelCharacters), limits.labels), description('Words of the host for the controls of the board: `button-a`, `button-b`, `touch-logo`, `start-simulator`.'))), // prettier-ignore
  }),
  'set-mode': v.strictObject({ mode: pipe(v.picklist(ARENA_MODES), description('`drive`: with the hand alone; `build`: with the tools for the course; `lookBack`: at the run.')) }), // prettier-ignore
  run: v.strictObject({ paused: maybe(flag('Whether the run begins paused.')) }),
  stop: nothing,
  reset: nothing,
  pause: nothing,
  resume: nothing,
  step: nothing,
  'get-break-points': v.strictObject(ofDevice),
  'set-break-points': v.strictObject({
    points: pipe(v.array(v.strictObject(place)), v.maxLength(limits.breakPoints), description('All break points of the program; none: it stops nowhere.')), // prettier-ignore
    ...ofDevice,
  }),
  'get-position': v.strictObject(ofDevice),
  'step-line': v.strictObject({
    step: pipe(v.picklist(STEPS), description('`over`: to the next line, calls in between run through; `into`: also into a call; `out`: until the function has returned; `back`: to the line that began before.')), // prettier-ignore
    ...ofDevice,
  }),
  'run-to': v.strictObject({ ...place, ...ofDevice }),
  'look-at': v.strictObject({ atMs: pipe(v.number(), v.finite(), v.minValue(0), description('Simulated time, up to which the run has come.')) }), // prettier-ignore
  'look-now': nothing,
  'go-on': v.strictObject({ paused: maybe(flag('Whether the run then stands.')) }),
  speed: v.strictObject({ speed }),
  seed: v.strictObject({ seed: pipe(v.number(), v.integer(), v.minValue(projectLimits.seed.min), v.maxValue(projectLimits.seed.max), description('Which of the used robots it is. Takes effect with the next run.')) }), // prettier-ignore
  reality: v.strictObject({ reality: pipe(v.number(), v.minValue(0), v.maxValue(1), description('0: ideal … 1: like a used school robot. Takes effect with the next run.')) }), // prettier-ignore
  place: v.strictObject({ ...poseFields, ...ofDevice }),
  'place-block': v.strictObject({ block: idOf('Id of a movable block.'), ...poseFields }),
  press: v.strictObject({ button: pipe(v.picklist(['a', 'b']), description('Which button.')), down: flag('Pressed or released.'), ...ofDevice }), // prettier-ignore
  touch: v.strictObject({
    pad: idOf('`pinLogo`, `pin0`, `pin1`, `pin2`, …'),
    down: flag('Touched or released.'),
    ...ofDevice,
  }),
  sensor: v.strictObject({ sensor: idOf('`lightLevel`, `temperature`, `accelerometerX`, `gesture`, …'), value: sensorValue, ...ofDevice }), // prettier-ignore
  'arena-senses': v.strictObject({ on: flag('Whether compass, accelerometer and light sensor measure the arena.') }),
  serial: v.strictObject({ text: pipe(textOf(limits.serialCharacters), description('As typed; Enter is `\\r`, Ctrl-C `\\x03`.')), ...ofDevice }), // prettier-ignore
  interrupt: v.strictObject(ofDevice),
  radio: v.union([
    v.strictObject({
      text: pipe(textOf(limits.radioBytes), description('As `radio.send` of another board sends it.')),
      ...toDevice,
    }),
    v.strictObject({ bytes: pipe(v.array(pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(255))), v.maxLength(limits.radioBytes), description('As `radio.send_bytes` sends them.')), ...toDevice }), // prettier-ignore
  ]),
  'clear-console': nothing,
} satisfies { readonly [N in CommandName]: v.GenericSchema<unknown, Commands[N]['fields']> };

/** All names of commands, in the order of the manual. */
export const commandNames = Object.keys(commandSchemas) as readonly CommandName[];
