import { LANGUAGES } from '#core/languages';
import { parseProject, parseProjectValue, projectToText } from '#project/file';
import { deviceNames, filesOfDevice } from '#project/devices';
import { FILE_BYTES, MAIN, projectLimits, type Project } from '#project/project';
import { parseEdit } from '#scene/check-edit';
import { parseScene, parseSceneValue } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import type { InputAction } from '#simulation/input';
import { SPEEDS } from '#simulation/pace';
import { placeOfDevice } from '#simulation/several/place-of-device';
import { endedWord, msOf } from '#simulation/report';

import { PARTS, type EmbeddedSimulator, type Refusal } from '../simulator';
import { commandNames } from './command-schemas';
import { doDebug } from './do-debug';
import { eventNames } from './event-schemas';
import { limits } from './limits';
import { plainSnapshot } from './plain-snapshot';
import type { Abilities, CommandName, Commands, PageSettings, ProjectFile, RobotChoice, SceneFile } from './protocol';
import { PROTOCOL_VERSION, refusal, type CommandRefusal, type ReadCommand } from './read-command';
import type { EventSender } from './event-sender';

/** The page's data for this dialect. */
export interface PageFacts {
  /** Version of the app. */
  readonly app: string;
  /** A text that changes with every load of the page. */
  readonly page: string;
  /** Ids of the microcomputers and robots that can be chosen. */
  readonly devices: readonly string[];
  readonly robots: readonly string[];
  /** Ids of the ready courses. */
  readonly courses: readonly string[];
}

/** The result of a command: the fields of its answer, or why it was not carried out. */
export type Outcome = { readonly done: object } | { readonly refused: CommandRefusal };

/** The port and facts that commands use. */
export interface CommandReach {
  readonly simulator: EmbeddedSimulator;
  readonly sender: EventSender;
  readonly facts: PageFacts;
}

const DONE: Outcome = { done: {} };
const done = <N extends CommandName>(_name: N, answer: Commands[N]['result']): Outcome => ({ done: answer });
const refused = (problem: CommandRefusal): Outcome => ({ refused: problem });
const from = (problem: Refusal): Outcome => (problem === null ? DONE : refused(refusal('refused', problem)));

/** Carries out a command; the promise resolves when it is done. */
export function doCommand(command: ReadCommand, reach: CommandReach): Outcome | Promise<Outcome> {
  const { simulator, sender } = reach;
  switch (command.type) {
    case 'hello':
      return done('hello', { versions: [PROTOCOL_VERSION], app: reach.facts.app, page: reach.facts.page, abilities: abilities(reach.facts) }); // prettier-ignore
    case 'bye':
      return DONE;
    case 'subscribe':
      sender.subscribe(command.fields);
      return DONE;
    case 'state':
      return done('state', stateOf(simulator));
    case 'run':
      return simulator.run(command.fields.paused ?? false).then(from);
    case 'stop':
      return simulator.stop().then(() => DONE);
    case 'reset':
      return simulator.reset().then(() => DONE);
    case 'pause':
    case 'resume':
    case 'step':
      return from(simulator[command.type]());
    case 'clear-console':
      simulator.clearConsole();
      return DONE;
    case 'set-robot':
    case 'settings':
    case 'speed':
    case 'seed':
    case 'reality':
      return from(simulator.change(command.fields));
    case 'arena-senses':
      return from(simulator.change({ arenaSenses: command.fields.on }));
    case 'set-mode':
      return from(simulator.enterMode(command.fields.mode));
    case 'get-robot':
      return done('get-robot', robotOf(simulator));
    case 'get-settings':
      return done('get-settings', pageOf(simulator));
    case 'get-break-points':
    case 'set-break-points':
    case 'get-position':
    case 'step-line':
    case 'run-to':
    case 'look-at':
    case 'look-now':
    case 'go-on':
      return debugged(doDebug(command, simulator.debug));
    default:
      return doToWork(command, simulator);
  }
}

/** The outcome of a command of `do-debug.ts`. */
function debugged(came: ReturnType<typeof doDebug>): Outcome | Promise<Outcome> {
  if (came instanceof Promise) return came.then((now) => debugged(now));
  return came !== null && typeof came === 'object' ? { done: came.answer } : from(came);
}

type WorkCommand = Extract<
  ReadCommand,
  { type: 'get-project' | 'set-project' | 'get-files' | 'set-files' | 'get-scene' | 'set-scene' | 'edit' }
>;
type InputCommand = Extract<
  ReadCommand,
  { type: 'place' | 'place-block' | 'press' | 'touch' | 'sensor' | 'serial' | 'interrupt' | 'radio' }
>;

function doToWork(command: WorkCommand | InputCommand, simulator: EmbeddedSimulator): Outcome {
  switch (command.type) {
    case 'get-project':
      return done('get-project', { project: JSON.parse(projectToText(simulator.project())) as ProjectFile });
    case 'set-project':
      return setProject(command.fields.project, simulator);
    case 'get-files':
      return filesOf(simulator.project(), command.fields.device);
    case 'set-files': {
      const { files, device } = command.fields;
      const isMain = ({ name }: { readonly name: string }): boolean => name === MAIN;
      return from(simulator.setFiles([...files.filter(isMain), ...files.filter((file) => !isMain(file))], device));
    }
    case 'get-scene':
      return done('get-scene', { scene: JSON.parse(serializeScene(simulator.project().scene)) as SceneFile });
    case 'set-scene':
      return setScene(command.fields.scene, simulator);
    case 'edit': {
      const parsed = parseEdit(command.fields.edit);
      return 'edit' in parsed ? from(simulator.edit(parsed.edit)) : wrongDocument('edit', parsed.problems);
    }
    default:
      return doInput(command, simulator);
  }
}

function setProject(given: unknown, simulator: EmbeddedSimulator): Outcome {
  const parsed = typeof given === 'string' ? parseProject(given) : parseProjectValue(given);
  return 'project' in parsed ? from(simulator.openProject(parsed.project)) : wrongDocument('project', parsed.problems);
}

function setScene(given: unknown, simulator: EmbeddedSimulator): Outcome {
  const parsed = typeof given === 'string' ? parseScene(given) : parseSceneValue(given);
  return 'scene' in parsed ? from(simulator.setScene(parsed.scene)) : wrongDocument('scene', parsed.problems);
}

/** The first problem, with its place in the message. */
function wrongDocument(
  field: string,
  problems: readonly { readonly path: string; readonly message: string }[],
): Outcome {
  const [first] = problems;
  const path = first === undefined || first.path === '' ? field : `${field}.${first.path}`;
  return refused(refusal('wrong-document', first?.message ?? 'It cannot be read.', path));
}

function doInput(command: InputCommand, simulator: EmbeddedSimulator): Outcome {
  const action = actionOf(command);
  const phase = simulator.phase();
  const isRunning = phase === 'starting' || phase === 'running' || phase === 'paused';
  // A sensor's number holds for later runs as well; every other action happens to a run.
  if (!isRunning && !(action.type === 'sensor' && typeof action.value === 'number'))
    return refused(refusal('refused', `This needs a run; it is "${phase}".`));
  return from(simulator.input(action, 'device' in command.fields ? command.fields.device : undefined));
}

function filesOf(project: Project, device: string | undefined): Outcome {
  const place = placeOfDevice(deviceNames(project), device);
  if (typeof place === 'string') return from(place);
  return done('get-files', { files: filesOfDevice(project, place) });
}

function actionOf(command: InputCommand): InputAction {
  switch (command.type) {
    case 'place': {
      const { xMm, yMm, headingDeg } = command.fields;
      return { type: 'place', pose: { xMm, yMm, headingDeg } };
    }
    case 'place-block': {
      const { block, ...pose } = command.fields;
      return { type: 'place-block', id: block, pose };
    }
    case 'press':
      return { type: 'button', button: command.fields.button, down: command.fields.down };
    case 'touch':
      return { type: 'touch', pad: command.fields.pad, down: command.fields.down };
    case 'sensor':
      return { type: 'sensor', id: command.fields.sensor, value: command.fields.value };
    case 'serial':
      return { type: 'serial', text: command.fields.text };
    case 'interrupt':
      return { type: 'interrupt' };
    case 'radio':
      return 'bytes' in command.fields
        ? { type: 'radio', bytes: command.fields.bytes }
        : { type: 'radio', text: command.fields.text };
    default:
      return command satisfies never;
  }
}

function stateOf(simulator: EmbeddedSimulator): Commands['state']['result'] {
  const { speed, seed, reality, arenaSenses } = simulator.settings();
  const [ended, snapshot, project] = [simulator.ended(), simulator.snapshot(), simulator.project()];
  return {
    phase: simulator.phase(),
    atMs: msOf(simulator.nowUs()),
    ...(project.devices !== undefined && { devices: deviceNames(project) }),
    board: simulator.board(),
    ended: ended && endedWord(ended),
    snapshot: snapshot && plainSnapshot(snapshot),
    mode: simulator.mode(),
    looking: simulator.debug.isLookingBack(),
    sensors: simulator.sensorWishes(),
    ...{ speed, seed, reality, arenaSenses },
  };
}

function robotOf(simulator: EmbeddedSimulator): RobotChoice {
  const { robot, robotOptions, device, firmware } = simulator.settings();
  return { robot, robotOptions, device, firmware };
}

function pageOf(simulator: EmbeddedSimulator): PageSettings {
  const { language, theme, muted, parts } = simulator.settings();
  return { language, theme, muted, parts };
}

function abilities({ devices, robots, courses }: PageFacts): Abilities {
  const { serialCharacters, waitingCommands, snapshotHz, outputCharactersPerSecond } = limits;
  const own = { serialCharacters, waitingCommands, snapshotHz, outputCharactersPerSecond };
  return {
    commands: commandNames,
    events: eventNames,
    ...{ devices, robots, courses, languages: LANGUAGES, speeds: SPEEDS, parts: PARTS },
    limits: { files: projectLimits.files, fileBytes: FILE_BYTES, ...own },
  };
}
