import { basename } from 'node:path';
import { boardOf } from '#board/boards/board-of-device';
import { optionProblem, type OptionValues } from '#core/option';
import { traitsFor } from '#my-robot/traits-for';
import { modulesImportedBy } from '#python/imports';
import { bareOptions } from '#robots/bare-options';
import { IN_HAND } from '#robots/in-hand';
import type { Traits } from '#robots/traits';
import { feelingInputs } from '#simulation/feeling';
import {
  AUTO,
  chooseFurtherHardware,
  chooseHardware,
  furtherRobot,
  hardwareIds,
  type FurtherWish,
  type Hardware,
} from '#simulation/hardware';
import { NO_ROBOT, type DeviceSetup, type RunSetup } from '#simulation/run-setup';
import { furtherStart } from '#simulation/several/starts';
import type { RunFiles } from './read-files';
import { isAddress } from './read-work';
import type { SetupAsked } from './run-arguments';

/** Default time limit of a run: ten minutes, longer than any lesson's program. */
export const DEFAULT_LIMIT_US = 600_000_000;

/** A run before it begins. */
export interface PreparedRun<Asked extends SetupAsked> {
  /** With what the project says where the command line leaves it open. */
  readonly options: Asked;
  readonly hardware: Hardware;
  readonly setup: RunSetup;
}

/** The run that is asked for, of the files that were read; or what is wrong with it. */
export function preparedRun<Asked extends SetupAsked>(
  asked: Asked,
  read: RunFiles,
): PreparedRun<Asked> | { readonly problem: string } {
  const options = withProject(asked, read.settings);
  const hardware = chooseHardware({ ...withMyRobot(options, read), ...read, imports: modulesImportedBy(read.files) });
  if ('problem' in hardware) return { problem: placed(hardware.problem, options) };
  const [option] = Object.keys(options.robotOptions);
  if (hardware.robot === null && option !== undefined && option !== IN_HAND)
    return { problem: `--option ${option}: there is no robot here. Leave it out, or choose --robot.` };
  const bare = bareOptionsProblem(hardware, options.robotOptions);
  if (bare !== null) return { problem: `--option: ${bare}` };
  const setup = setupOf(options, read, hardware);
  return 'problem' in setup ? setup : { options, hardware, setup };
}

/** The first device has the name of its program. */
const firstName = ({ program }: SetupAsked): string =>
  isAddress(program) ? 'link' : basename(program).replace(/(\.parcours)?\.[^.]*$/, '') || basename(program);

/** The devices after the first: those of the project, then those that `--device` adds. */
function furtherDevices(
  { devices }: SetupAsked,
  read: RunFiles,
  first: Hardware,
): { readonly devices: readonly DeviceSetup[] } | { readonly problem: string } {
  const { scene } = read;
  const added = devices.map(({ name, robotOptions: own, ...asked }, place) => {
    const { files = {}, settings = {} } = read.added[place] ?? {};
    const { robot, board, firmware } = withProject({ ...asked, firmware: '' }, settings);
    return {
      name,
      robot,
      board,
      firmware,
      robotOptions: settings.robotOptions ?? {},
      own,
      files,
      from: `--device ${name}`,
    };
  });
  const ofProject = read.devices.map((device) => ({ ...device, own: {}, from: `device "${device.name}"` }));
  const made: DeviceSetup[] = [];
  let robots = first.robot === null ? 0 : 1;
  for (const { name, files, from, own, ...asked } of [...ofProject, ...added]) {
    const start = robots === 0 ? null : furtherStart(scene, robots);
    const wish = withOwnOptions({ ...asked, scene, start, imports: modulesImportedBy(files) }, own);
    const hardware = chooseFurtherHardware(wish);
    const problem = 'problem' in hardware ? hardware.problem : bareOptionsProblem(hardware, own);
    if ('problem' in hardware || problem !== null) return { problem: `${from}: ${problem ?? ''}` };
    if (hardware.robot !== null) robots++;
    made.push({ name, files, ...hardwareIds(hardware), robotOptions: hardware.options });
  }
  return { devices: made };
}

/** The wish with further options for the robot that it gives, or for the bare board. */
function withOwnOptions(wish: FurtherWish, own: OptionValues): FurtherWish {
  const id = furtherRobot(wish);
  return { ...wish, robotOptions: { ...wish.robotOptions, [id]: { ...wish.robotOptions[id], ...own } } };
}

/** The mistake in options that were asked for a board without a robot; `null`: none, or it has one. */
function bareOptionsProblem({ robot, board }: Hardware, own: OptionValues): string | null {
  const problem = robot === null ? optionProblem(bareOptions(board), own) : null;
  return problem === null ? null : `${board.name} without a robot: ${problem}`;
}

/** The run of the program on this hardware, with the devices that are added. */
function setupOf(options: SetupAsked, read: RunFiles, hardware: Hardware): RunSetup | { readonly problem: string } {
  const traits = traitsOf(read, hardware);
  if ('problem' in traits) return traits;
  const further = furtherDevices(options, read, hardware);
  if ('problem' in further) return further;
  const { scene, files, inputs, settings } = read;
  const robotOptions = { ...settings.robotOptions?.[hardware.robot?.id ?? NO_ROBOT], ...options.robotOptions };
  const first = {
    name: read.firstName ?? firstName(options),
    files,
    ...hardwareIds(hardware),
    robotOptions,
    ...traits,
  };
  const all = [first, ...further.devices] as const;
  return {
    scene,
    devices: all,
    inputs: (options.senses ?? settings.arenaSenses) ? [...feelingInputs(all), ...inputs] : inputs,
    ...chanceOf(options, read.settings),
  };
}

/** Takes settings of the project that the command line leaves open. */
function withProject<T extends Pick<SetupAsked, 'robot' | 'board' | 'firmware'>>(
  options: T,
  settings: RunFiles['settings'],
): T {
  const { device = AUTO, firmware = '', robot = AUTO } = settings;
  return {
    ...options,
    robot: options.robot === AUTO ? robot : options.robot,
    board: options.board === AUTO ? boardOf(device) : options.board,
    firmware: options.firmware === '' && options.board === AUTO ? firmware : options.firmware,
  };
}

/** Seed and *reality*; the project's seed counts only if the robot is not ideal. */
export function chanceOf(
  options: Pick<SetupAsked, 'seed' | 'reality'>,
  settings: RunFiles['settings'],
): { readonly seed: number; readonly reality: number } {
  const reality = options.reality ?? settings.reality ?? 0;
  return { reality, seed: options.seed ?? (reality > 0 ? (settings.seed ?? 1) : 1) };
}

/** Unless a robot is named, a measured one drives. */
const withMyRobot = <Asked extends SetupAsked>(options: Asked, { myRobot }: RunFiles): Asked =>
  myRobot === null || options.robot !== AUTO ? options : { ...options, robot: myRobot.robot };

/** The measured traits of the robot that drives. */
function traitsOf(
  { myRobot, settings }: RunFiles,
  { robot }: Hardware,
): { readonly traits?: Traits } | { readonly problem: string } {
  if (myRobot === null) {
    const traits = traitsFor(settings.myRobot, robot?.id);
    return traits === undefined ? {} : { traits };
  }
  if (robot?.id === myRobot.robot) return { traits: myRobot.traits };
  const here = robot === null ? 'there is no robot here' : `here drives a ${robot.id}`;
  return {
    problem: `--my-robot: "${myRobot.name}" is a ${myRobot.robot}, but ${here}. Choose --robot ${myRobot.robot}.`,
  };
}

/**
 * Names the file of a problem of the whole set-up.
 *
 * @param added number of inputs of the run before those of the input file
 */
export function placed(problem: string, options: SetupAsked, added = 0): string {
  if (problem.startsWith('[') && options.input !== null)
    return `${options.input}: ${problem.replace(/\d+/, (place) => String(Number(place) - added))}`;
  if (/^(robot\.|board:|background\.)/.test(problem) && options.scene !== null) return `${options.scene}: ${problem}`;
  return problem;
}
