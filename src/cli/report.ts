import type { Help } from '#scene/scene';
import {
  displayText,
  endedWord,
  robotReport,
  rounded,
  type EndedWord,
  type PacketReport,
  type RobotReport,
} from '#simulation/report';
import type { Ended, Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

/** How a run ended, as a word for programs; `time-limit`: its program went on. */
export type RunEndedWord = EndedWord | 'time-limit';

/** Everything about a run except its console: the content of `--json`, in this order. */
export interface Report {
  readonly ended: RunEndedWord;
  readonly exception: Ended['exception'];
  readonly simulatedMs: number;
  readonly wallMs: number;
  readonly realTimeFactor: number;
  readonly robot: RobotReport | null;
  /** Digits 0 … 9 per LED, rows separated by colons. */
  readonly display: string;
  /** How well the course's task is done, or `null` if the course has no task. */
  readonly verdict: Verdict | null;
  readonly heapFree: number;
  readonly traceHash: string;
  /** The packets sent by radio, oldest first; the first 10,000. */
  readonly radio: readonly PacketReport[];
  /** Chains of colour lights on pins that no robot uses: rings and strips to which the program has sent colours. */
  readonly lights: Snapshot['lights'];
}

/** The report on a run now. While its program goes on, `ended` is `time-limit`. */
export function reportOf(simulation: Simulation, sent: readonly PacketReport[], wallMs: number): Report {
  const { ended, nowUs } = simulation;
  const snapshot = simulation.snapshot();
  const simulatedMs = nowUs / 1000;
  return {
    ended: runEndedWord(simulation),
    exception: ended?.exception ?? null,
    simulatedMs,
    wallMs: rounded(wallMs),
    realTimeFactor: wallMs > 0 ? rounded(simulatedMs / wallMs) : 0,
    robot: snapshot.robot && robotReport(snapshot.robot),
    display: displayText(snapshot.display),
    verdict: snapshot.verdict,
    heapFree: simulation.heapFree(),
    traceHash: simulation.traceHash,
    radio: sent,
    lights: snapshot.lights,
  };
}

/** A program that switches the board off has finished, too. */
function runEndedWord({ ended, isOff }: Pick<Simulation, 'ended' | 'isOff'>): RunEndedWord {
  return ended === null ? (isOff ? 'finished' : 'time-limit') : endedWord(ended);
}

/** The line that `--json` prints; it has `radio` and `lights` only if they are not empty. */
export function jsonLine(report: Report, console: string): string {
  const { heapFree, traceHash, radio, lights, ...rest } = report;
  const some = { ...(radio.length > 0 ? { radio } : {}), ...(lights.length > 0 ? { lights } : {}) };
  return JSON.stringify({ ...rest, console, heapFree, traceHash, ...some });
}

/** 0 for a run without exception, 1 for one that ended badly. */
export function exitCodeOf(ended: RunEndedWord): 0 | 1 {
  return ended === 'finished' || ended === 'time-limit' ? 0 : 1;
}

/** The result of the course's task, as a line for people; `null` if the course has no task. */
export function verdictLine(verdict: Verdict | null): string | null {
  if (verdict === null) return null;
  const { state, atMs } = verdict;
  const seconds = `${((atMs ?? 0) / 1000).toFixed(1)} s`;
  switch (state) {
    case 'passed':
      return `Task: passed after ${seconds}${withStars(verdict)}${withHelp(verdict)}.`;
    case 'helped':
      return `Task: done after ${seconds}${withHelp(verdict)}: does not count as passed.`;
    case 'failed':
      return `Task: failed after ${seconds}${withHelp(verdict)}: ${failureInWords(verdict)}.`;
    case 'open':
      return `Task: not done${progressInWords(verdict)}${earlyInWords(verdict)}${withHelp(verdict)}.`;
    default:
      return state satisfies never;
  }
}

function failureInWords(verdict: Verdict): string {
  const { reason, by } = verdict;
  switch (reason) {
    case 'time':
      return `the time was over${progressInWords(verdict)}${earlyInWords(verdict)}`;
    case 'forbidden':
      return `the robot came into the forbidden zone "${by ?? ''}"`;
    case 'spikes':
      return `the robot touched the spikes "${by ?? ''}"`;
    case 'touched':
      return by === null ? 'the robot touched the edge of the arena' : `the robot touched "${by}"`;
    case null:
      return 'without a reason'; // nothing fails so
    default:
      return reason satisfies never;
  }
}

const helpWords: Readonly<Record<Help, string>> = {
  hand: 'with help by hand',
  edits: 'with a course that was changed',
};

/** `, 2 of 3 stars`, or nothing where the task gives none. */
const withStars = ({ stars }: Verdict): string => (stars === null ? '' : `, ${stars} of 3 stars`);

/** `, with help by hand`, or nothing. */
const withHelp = ({ help }: Verdict): string => help.map((one) => `, ${helpWords[one]}`).join('');

/** `; checkpoint 2 came before 1`, or nothing if all came in their order. */
function earlyInWords({ early }: Verdict): string {
  if (early === null) return '';
  const what = early.number === 0 ? 'a target' : `checkpoint ${early.number}`;
  return `; ${what} came before checkpoint ${early.before}`;
}

/** ` (1 of 3 checkpoints, 0 of 1 target)`, or nothing if there is nothing to reach. */
function progressInWords({ checkpoints, targets, blocks }: Verdict): string {
  const parts = [
    counted(checkpoints.passed, checkpoints.of, 'checkpoint'),
    counted(targets.reached, targets.of, 'target'),
    counted(blocks.delivered, blocks.of, 'block'),
  ].filter((part) => part !== null);
  return parts.length > 0 ? ` (${parts.join(', ')})` : '';
}

const counted = (done: number, of: number, what: string): string | null =>
  of === 0 ? null : `${done} of ${of} ${what}${of === 1 ? '' : 's'}`;
