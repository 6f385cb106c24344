import { textBytesOf } from '#board/radio-text';
import type { RadioPacket, Simulation, Snapshot, Verdict } from '#simulation/simulation';

/** How a run ended, as a word for programs. */
export type EndedWord = 'finished' | 'time-limit' | 'exception' | 'panic' | 'stopped' | 'stuck';

/** The exception that ended the program. */
export interface ReportedException {
  readonly type: string;
  readonly message: string;
  readonly line: number | null;
  readonly traceback: string;
}

/** The robot at the end. */
export interface ReportedRobot {
  readonly type: string;
  readonly xMm: number;
  readonly yMm: number;
  /** Counter-clockwise from +x, more than −180 up to 180. */
  readonly headingDeg: number;
  /** Since the start, counter-clockwise positive, not wrapped. */
  readonly turnedDeg: number;
  readonly pathMm: number;
  readonly collisions: number;
  readonly leds: { readonly left: number; readonly right: number };
  readonly rgb: readonly (readonly [number, number, number])[];
  readonly servos: Readonly<Record<string, number>>;
}

/** A packet that the program sent by radio: as text if `radio.send` made it, otherwise its bytes. */
export type ReportedPacket = { readonly atMs: number } & (
  { readonly text: string } | { readonly bytes: readonly number[] }
);

/** Everything about a run except its console: the content of `--json`, in this order. */
export interface Report {
  readonly ended: EndedWord;
  readonly exception: ReportedException | null;
  readonly simulatedMs: number;
  readonly wallMs: number;
  readonly realTimeFactor: number;
  readonly robot: ReportedRobot | null;
  /** Digits 0 … 9 per LED, rows separated by colons. */
  readonly display: string;
  /** How well the course's task is done, or `null` if the course has no task. */
  readonly verdict: Verdict | null;
  readonly heapFree: number;
  readonly traceHash: string;
  /** The packets sent by radio, oldest first; the first 10,000. */
  readonly radio: readonly ReportedPacket[];
  /** Chains of colour lights on pins that no robot uses: rings and strips to which the program has sent colours. */
  readonly lights: Snapshot['lights'];
}

/** The report on a run now. While its program goes on, `ended` is `time-limit`. */
export function reportOf(simulation: Simulation, sent: readonly ReportedPacket[], wallMs: number): Report {
  const { ended, nowUs } = simulation;
  const snapshot = simulation.snapshot();
  const simulatedMs = nowUs / 1000;
  return {
    ended: endedWord(simulation),
    exception: ended?.exception ?? null,
    simulatedMs,
    wallMs: rounded(wallMs),
    realTimeFactor: wallMs > 0 ? rounded(simulatedMs / wallMs) : 0,
    robot: snapshot.robot && reportedRobot(snapshot.robot),
    display: displayText(snapshot.display),
    verdict: snapshot.verdict,
    heapFree: simulation.heapFree(),
    traceHash: simulation.traceHash,
    radio: sent,
    lights: snapshot.lights,
  };
}

/** A program that switches the board off has also finished. */
function endedWord({ ended, isOff }: Pick<Simulation, 'ended' | 'isOff'>): EndedWord {
  if (ended === null) return isOff ? 'finished' : 'time-limit';
  return ended.kind === 'fault' ? 'panic' : ended.kind;
}

/** The line that `--json` prints; it has `radio` and `lights` only if they are not empty. */
export function jsonLine(report: Report, console: string): string {
  const { heapFree, traceHash, radio, lights, ...rest } = report;
  const some = { ...(radio.length > 0 ? { radio } : {}), ...(lights.length > 0 ? { lights } : {}) };
  return JSON.stringify({ ...rest, console, heapFree, traceHash, ...some });
}

/** A packet in the form of the report. */
export function reportedPacket({ timeUs, bytes }: RadioPacket): ReportedPacket {
  const atMs = timeUs / 1000;
  const text = textBytesOf(bytes);
  return text === null ? { atMs, bytes } : { atMs, text: new TextDecoder().decode(text) };
}

/** 0 for a run without exception, 1 for one that ended badly. */
export function exitCodeOf(ended: EndedWord): 0 | 1 {
  return ended === 'finished' || ended === 'time-limit' ? 0 : 1;
}

function reportedRobot(robot: NonNullable<ReturnType<Simulation['snapshot']>['robot']>): ReportedRobot {
  const { pose, state } = robot;
  return {
    type: robot.type,
    xMm: rounded(pose.xMm),
    yMm: rounded(pose.yMm),
    headingDeg: rounded(wrappedDeg(degOf(pose.headingRad))),
    turnedDeg: rounded(degOf(robot.turnedRad)),
    pathMm: rounded(robot.pathMm),
    collisions: robot.collisions,
    leds: { left: state.leds.left, right: state.leds.right },
    rgb: state.rgb,
    servos: state.servos,
  };
}

/** Radians to degrees. */
export const degOf = (rad: number): number => (rad * 180) / Math.PI;

/** The same direction, more than −180° up to 180°. */
export function wrappedDeg(deg: number): number {
  const rest = deg % 360;
  return rest > 180 ? rest - 360 : rest <= -180 ? rest + 360 : rest;
}

/** To three digits after the point, without a negative zero: enough for reading; the exact run is in the trace hash. */
export const rounded = (value: number): number => Math.round(value * 1000) / 1000 + 0;

const displayText = (pixels: readonly number[]): string =>
  [0, 5, 10, 15, 20].map((row) => pixels.slice(row, row + 5).join('')).join(':');

/** The result of the course's task, as a line for people; `null` if the course has no task. */
export function verdictLine(verdict: Verdict | null): string | null {
  if (verdict === null) return null;
  const { state, atMs } = verdict;
  const seconds = `${((atMs ?? 0) / 1000).toFixed(1)} s`;
  switch (state) {
    case 'passed':
      return `Task: passed after ${seconds}.`;
    case 'failed':
      return `Task: failed after ${seconds}: ${failureInWords(verdict)}.`;
    case 'open':
      return `Task: not done${progressInWords(verdict)}.`;
    default:
      return state satisfies never;
  }
}

function failureInWords(verdict: Verdict): string {
  const { reason, by } = verdict;
  switch (reason) {
    case 'time':
      return `the time was over${progressInWords(verdict)}`;
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
