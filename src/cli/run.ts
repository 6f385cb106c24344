import { existsSync, rmSync, statSync } from 'node:fs';
import { basename } from 'node:path';
import { findBoard } from '#board/boards/index';
import { traitsFor } from '#my-robot/my-robot';
import { importsOf, modulesImportedBy } from '#python/imports';
import type { Traits } from '#robots/traits';
import { AUTO, chooseFurtherHardware, chooseHardware, hardwareIds, type Hardware } from '#simulation/hardware';
import { boardOf } from '#board/boards/board-of-device';
import { feelingInputs } from '#simulation/feeling';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';
import { robotFault } from '#simulation/robot-fit';
import { hasTask } from '#simulation/task/task-brief';
import { furtherStart } from '#simulation/several/starts';
import type { RunOptions } from './run-arguments';
import { withAdvice } from './explained';
import { outputProblem } from './outputs';
import { readRunFiles, type RunFiles } from './read-files';
import { isAddress } from './read-work';
import { exitCodeOf, jsonLine, runEnding, type Report } from './report';
import { nothingYet, supervise } from './supervise';
import { printable, type Terminal } from './terminal';
import { verdictLines } from './verdict-lines';
import { closeOutput, openOutput } from './write-output';

/** Default time limit of a run: ten minutes, longer than any lesson's program. */
const DEFAULT_LIMIT_US = 600_000_000;

/**
 * Carries out `parcours run`.
 *
 * @returns the exit code: 0 success, 1 the program ended with an error, 2 bad usage or a bad file, 3 the task is not passed
 *   (only with `--until-verdict`)
 */
export async function run(asked: RunOptions, terminal: Terminal): Promise<0 | 1 | 2 | 3> {
  const read = await readRunFiles(asked);
  if ('problem' in read) return refuse(read.problem, terminal);
  const options = withProject(asked, read.settings);
  const chosen = chooseHardware({ ...withMyRobot(options, read), ...read, imports: modulesImportedBy(read.files) });
  if ('problem' in chosen) return refuse(placed(chosen.problem, options), terminal);
  const [option] = Object.keys(options.robotOptions);
  if (chosen.robot === null && option !== undefined)
    return refuse(`--option ${option}: there is no robot here. Leave it out, or choose --robot.`, terminal);
  const setup = setupOf(options, read, chosen);
  if ('problem' in setup) return refuse(setup.problem, terminal);
  const unfit = options.strict ? await strictFailure(setup.devices, options, terminal) : null;
  if (unfit) {
    if (options.json) terminal.line(jsonLine(unfit, []));
    return exitCodeOf(unfit.ended);
  }
  if (options.untilVerdict && !hasTask(setup.scene))
    return refuse('--until-verdict: the course has no task. Choose a course with a target: --scene', terminal);
  const results = openResults(options);
  if ('problem' in results) return refuse(results.problem, terminal);
  const { trace, log, record } = results;
  for (const note of read.notes) terminal.message(`parcours: ${note}`);
  tellUnfit(chosen, read, terminal);
  const outcome = await supervise(
    {
      setup: { ...setup, keepTrace: trace !== null },
      untilUs: options.forUs ?? DEFAULT_LIMIT_US,
      untilProgramEnds: options.forUs === null && !options.untilVerdict,
      untilVerdict: options.untilVerdict,
      traceFile: trace,
      logFile: log,
      tapeFile: record,
      replay: null,
    },
    terminal,
  );
  results.close(outcome.type === 'ran');
  switch (outcome.type) {
    case 'refused':
      return refuse(placed(outcome.problem, options, (setup.inputs?.length ?? 0) - read.inputs.length), terminal);
    case 'broken':
      terminal.message(`parcours: something broke inside. Please report this.\n${outcome.problem}`);
      return 1;
    case 'ran': {
      const report = withAdvice(outcome.report, setup.devices, options.lang);
      tellEnd(report, options, terminal);
      if (!options.json && !options.quiet) tellVerdict(report, options, terminal);
      if (options.json) terminal.line(jsonLine(report, outcome.consoles));
      return options.untilVerdict ? verdictCodeOf(report) : exitCodeOf(runEnding(report));
    }
  }
}

/** 0 for a task that is passed, 3 for one that is not: the codes of `check`. */
const verdictCodeOf = ({ verdict }: Report): 0 | 3 => (verdict?.state === 'passed' ? 0 : 3);

/** The first device has the name of its program. */
const firstName = ({ program }: RunOptions): string =>
  isAddress(program) ? 'link' : basename(program).replace(/(\.parcours)?\.[^.]*$/, '') || basename(program);

/** The devices after the first: those of the project, then those that `--device` adds. */
function furtherDevices(
  { devices }: RunOptions,
  read: RunFiles,
  first: Hardware,
): { readonly devices: readonly DeviceSetup[] } | { readonly problem: string } {
  const { scene } = read;
  const added = devices.map(({ name, ...asked }, place) => {
    const { files = {}, settings = {} } = read.added[place] ?? {};
    const { robot, board, firmware } = withProject({ ...asked, firmware: '' }, settings);
    return { name, robot, board, firmware, robotOptions: settings.robotOptions ?? {}, files, from: `--device ${name}` };
  });
  const ofProject = read.devices.map((device) => ({ ...device, from: `device "${device.name}"` }));
  const made: DeviceSetup[] = [];
  let robots = first.robot === null ? 0 : 1;
  for (const { name, files, from, ...wish } of [...ofProject, ...added]) {
    const start = robots === 0 ? null : furtherStart(scene, robots);
    const hardware = chooseFurtherHardware({ ...wish, scene, start, imports: modulesImportedBy(files) });
    if ('problem' in hardware) return { problem: `${from}: ${hardware.problem}` };
    if (hardware.robot !== null) robots++;
    made.push({ name, files, ...hardwareIds(hardware), robotOptions: hardware.options });
  }
  return { devices: made };
}

/** The run of the program on this hardware, with the devices that are added. */
function setupOf(options: RunOptions, read: RunFiles, hardware: Hardware): RunSetup | { readonly problem: string } {
  const traits = traitsOf(read, hardware);
  if ('problem' in traits) return traits;
  const further = furtherDevices(options, read, hardware);
  if ('problem' in further) return further;
  const { scene, files, inputs, settings } = read;
  const robotOptions = { ...settings.robotOptions?.[hardware.robot?.id ?? ''], ...options.robotOptions };
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
    ...chanceOf(options, read),
  };
}

/** Takes settings of the project that the command line leaves open. */
function withProject<T extends Pick<RunOptions, 'robot' | 'board' | 'firmware'>>(
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
function chanceOf(options: RunOptions, { settings }: RunFiles): { readonly seed: number; readonly reality: number } {
  const reality = options.reality ?? settings.reality ?? 0;
  return { reality, seed: options.seed ?? (reality > 0 ? (settings.seed ?? 1) : 1) };
}

/** Unless a robot is named, a measured one drives. */
const withMyRobot = (options: RunOptions, { myRobot }: RunFiles): RunOptions =>
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

function refuse(problem: string, terminal: Terminal): 2 {
  for (const line of problem.split('\n')) terminal.message(`parcours: ${line}`);
  return 2;
}

/**
 * Lists what the real board would not understand.
 *
 * @returns the report instead of a run, or `null` if the program can run
 */
async function strictFailure(
  devices: readonly DeviceSetup[],
  { lang }: RunOptions,
  terminal: Terminal,
): Promise<Report | null> {
  const { strictReport } = await import('./strict');
  let found = { text: '', first: '' };
  for (const { name, files, board: id, firmware: version } of devices) {
    const board = findBoard(id);
    const firmware = board?.firmwares.find((one) => one.id === version) ?? board?.firmwares[0];
    if (board === undefined || firmware === undefined) continue;
    const { text, count, first } = await strictReport(files, board.name, firmware, lang);
    const from = devices.length > 1 ? `${name}: ` : '';
    if (text !== '') terminal.message(text.trimEnd().replaceAll(/^/gm, from));
    if (count > 0 && found.first === '') found = { text, first: `${from}${first}` };
  }
  if (found.first === '') return null;
  const exception = { type: 'NotOnDevice', message: found.first, line: null, traceback: found.text };
  return { ...nothingYet, ended: 'exception', exception };
}

/**
 * Warns that the robot is on a board that it does not fit, or that the program is for another robot. The program will
 * meet the device's error or drive oddly, and this says why.
 */
function tellUnfit(hardware: Hardware, { files }: RunFiles, terminal: Terminal): void {
  const { foreign } = importsOf(files);
  const fault = robotFault(hardware, { all: foreign, foreign });
  if (fault === null) return;
  const { kind, fits, values } = fault;
  const { meant = '', robot = '', board = '', plugged = '' } = values;
  if (kind === 'misplugged') {
    terminal.message(
      `parcours: the ${robot} is made for the ${board}, but here a ${plugged} is plugged in: nothing of the robot is connected. Choose --board ${fits.board}, or another --robot.`,
    );
    return;
  }
  const here = kind === 'lacksRobot' ? 'there is no robot here' : `the robot here is the ${robot}`;
  terminal.message(`parcours: the program is for the ${meant}, but ${here}. Choose --robot ${fits.id}.`);
}

/**
 * Names the file of a problem of the whole set-up.
 *
 * @param added number of inputs of the run before those of the input file
 */
function placed(problem: string, options: RunOptions, added = 0): string {
  if (problem.startsWith('[') && options.input !== null)
    return `${options.input}: ${problem.replace(/\d+/, (place) => String(Number(place) - added))}`;
  if (/^(robot\.|board:|background\.)/.test(problem) && options.scene !== null) return `${options.scene}: ${problem}`;
  return problem;
}

/** Outputs of a run, each with a file of its own. */
const RESULTS = ['trace', 'log', 'record'] as const;
interface Results extends Readonly<Record<(typeof RESULTS)[number], number | null>> {
  /** Closes them; new ones of a run that was refused are removed again. */
  close(hasRun: boolean): void;
}

/** Opens the output files of the run, without emptying them yet: a refused run must not destroy an earlier result. */
function openResults(options: RunOptions): Results | { readonly problem: string } {
  const { program, files, devices, scene, input, myRobot } = options;
  const others = devices.flatMap((device) => [device.program, ...device.files]);
  const reads = [program, ...files, ...others, scene, input, myRobot].filter((name) => name !== null);
  const outputs = RESULTS.map((name) => ({ option: `--${name}`, path: options[name] }));
  const problem = outputProblem(outputs, reads, 'run');
  if (problem !== null) return { problem };
  const paths = outputs.flatMap(({ path }) => (path === null ? [] : [path]));
  const added = paths.filter((path) => !existsSync(path));
  const [trace = null, log = null, record = null] = outputs.map(({ path }) =>
    path === null ? null : openOutput(path),
  );
  return {
    ...{ trace, log, record },
    close(hasRun) {
      for (const file of [trace, log, record]) if (file !== null) closeOutput(file);
      for (const path of hasRun ? [] : added) if (statSync(path, { throwIfNoEntry: false })?.size === 0) rmSync(path);
    },
  };
}

/** The result of the course's task. */
function tellVerdict({ verdict }: Report, { lang }: RunOptions, terminal: Terminal): void {
  for (const line of verdictLines(verdict, lang)) terminal.message(printable(line));
}

/** A note that the programs' own output does not contain. */
function tellEnd({ ended, simulatedMs, devices }: Report, { quiet, forUs }: RunOptions, terminal: Terminal): void {
  if (ended === 'stuck') {
    terminal.message('parcours: no sign of life for 10 s: the program is inside one call that does not end. Stopped.');
  } else if (ended === 'time-limit' && forUs === null && simulatedMs * 1000 >= DEFAULT_LIMIT_US && !quiet) {
    terminal.message(
      `parcours: stopped after ${Math.round(simulatedMs / 60_000)} simulated minutes. A longer run: --for 30min`,
    );
  }
  for (const { name, exception } of devices) {
    if (exception === null) continue;
    const from = devices.length > 1 ? `${name}: ` : '';
    if (quiet) terminal.message(exception.traceback.trimEnd().replaceAll(/^/gm, from));
    if (exception.advice !== undefined) terminal.message(`parcours: ${from}${printable(exception.advice)}`);
  }
}
