import { existsSync, rmSync, statSync } from 'node:fs';
import { findBoard } from '#board/boards/index';
import { importsOf } from '#python/imports';
import type { Hardware } from '#simulation/hardware';
import type { DeviceSetup } from '#simulation/run-setup';
import { robotFault } from '#simulation/robot-fit';
import { hasTask } from '#simulation/task/task-brief';
import type { RunOptions } from './run-arguments';
import { withAdvice } from './explained';
import { outputProblem } from './outputs';
import { DEFAULT_LIMIT_US, placed, preparedRun } from './prepared-run';
import { readRunFiles, type RunFiles } from './read-files';
import { exitCodeOf, jsonLine, runEnding, type Report } from './report';
import { refuse } from './results-out';
import { nothingYet, supervise } from './supervise';
import { printable, type Terminal } from './terminal';
import { verdictLines } from './verdict-lines';
import { closeOutput, openOutput } from './write-output';

/**
 * Carries out `parcours run`.
 *
 * @returns the exit code: 0 success, 1 the program ended with an error, 2 bad usage or a bad file, 3 the task is not passed
 *   (only with `--until-verdict`)
 */
export async function run(asked: RunOptions, terminal: Terminal): Promise<0 | 1 | 2 | 3> {
  const read = await readRunFiles(asked);
  if ('problem' in read) return refuse(read.problem, terminal);
  const prepared = preparedRun(asked, read);
  if ('problem' in prepared) return refuse(prepared.problem, terminal);
  const { options, hardware, setup } = prepared;
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
  tellUnfit(hardware, read, terminal);
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
