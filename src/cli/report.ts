import { displayText, endedWord, robotReport, rounded, type EndedWord, type RobotReport } from '#simulation/report';
import type { Ended, Simulation } from '#simulation/simulation';
import type { SentPacket } from './radio-report';
import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

/** End of a run, as a word for programs; `time-limit`: its program was still running. */
export type RunEndedWord = EndedWord | 'time-limit';

/** The error of a program; `advice`: what it means, in the reader's language. */
type ReportedException = NonNullable<Ended['exception']> & { readonly advice?: string };

/** Everything about a run except its console: the content of `--json`, in this order. */
export interface Report {
  readonly ended: RunEndedWord;
  readonly exception: ReportedException | null;
  readonly simulatedMs: number;
  readonly wallMs: number;
  readonly realTimeFactor: number;
  readonly robot: RobotReport | null;
  /** Digits 0 … 9 per LED, rows separated by colons. */
  readonly display: string;
  /** Verdict on the course's task, or `null` if the course has none. */
  readonly verdict: Verdict | null;
  readonly heapFree: number;
  readonly traceHash: string;
  /** The packets sent by radio, oldest first: the first ones (`RadioKeeper`). */
  readonly radio: readonly SentPacket[];
  /** Number of packets sent. */
  readonly radioSent: number;
  /** Chains of colour lights on pins that no robot uses: rings and strips to which the program has sent colours. */
  readonly lights: Snapshot['lights'];
  /** All devices; the fields above are those of the first one. */
  readonly devices: readonly DeviceReport[];
}

/** One device. */
export interface DeviceReport extends Pick<
  Report,
  'ended' | 'exception' | 'robot' | 'display' | 'heapFree' | 'radio' | 'radioSent' | 'lights'
> {
  readonly name: string;
}

/** The report on a run now, without its packets. While a program is running, its `ended` is `time-limit`. */
export function reportOf(simulation: Simulation, wallMs: number): Report {
  const snapshot = simulation.snapshot();
  const simulatedMs = simulation.nowUs / 1000;
  const reportAt = (device: DeviceSnapshot, place: number): DeviceReport => {
    const ended = simulation.endings[place] ?? null;
    return {
      name: device.name,
      ended: runEndedWord(ended, device.power === 'off'),
      exception: ended?.exception ?? null,
      robot: device.robot && robotReport(device.robot),
      display: displayText(device.display),
      heapFree: simulation.heapFree(place),
      ...{ radio: [], radioSent: 0 },
      lights: device.lights,
    };
  };
  const first = reportAt(snapshot, 0);
  const { name: _, ...own } = first;
  return {
    ...own,
    simulatedMs,
    wallMs: rounded(wallMs),
    realTimeFactor: wallMs > 0 ? rounded(simulatedMs / wallMs) : 0,
    verdict: snapshot.verdict,
    traceHash: simulation.traceHash,
    devices: [first, ...snapshot.others.map((device, place) => reportAt(device, place + 1))],
  };
}

/** A program that switches the board off has finished, too. */
function runEndedWord(ended: Ended | null, isOff: boolean): RunEndedWord {
  return ended === null ? (isOff ? 'finished' : 'time-limit') : endedWord(ended);
}

/**
 * The line that `--json` prints; it has `radio` and `lights` only if they are not empty. The packets of the first
 * device are listed only at the top: there may be many.
 *
 * @param consoles output of each device's program
 */
export function jsonLine(report: Report, consoles: readonly string[]): string {
  const { ended, exception, simulatedMs, wallMs, realTimeFactor, robot, display, verdict } = report;
  const { heapFree, traceHash, devices } = report;
  return JSON.stringify({
    ...{ ended, exception, simulatedMs, wallMs, realTimeFactor, robot, display, verdict },
    console: consoles[0] ?? '',
    ...{ heapFree, traceHash, ...someOf(report) },
    devices: devices.map((device, place) =>
      deviceLine(place === 0 ? { ...device, radio: [] } : device, consoles[place] ?? ''),
    ),
  });
}

const deviceLine = (device: DeviceReport, console: string) => {
  const { name, ended, exception, display, robot, heapFree } = device;
  return { name, ended, exception, console, display, robot, heapFree, ...someOf(device) };
};

const someOf = ({ radio, radioSent, lights }: Pick<Report, 'radio' | 'radioSent' | 'lights'>) => ({
  ...(radio.length > 0 ? { radio, radioSent } : {}),
  ...(lights.length > 0 ? { lights } : {}),
});

/** End of the run as a whole: an error, if one of its programs had one. */
export const runEnding = ({ ended, devices }: Report): RunEndedWord =>
  devices.map((device) => device.ended).find((one) => exitCodeOf(one) === 1) ?? ended;

/** 0 for a run that finished or reached its time limit, 1 for any other end. */
export function exitCodeOf(ended: RunEndedWord): 0 | 1 {
  return ended === 'finished' || ended === 'time-limit' ? 0 : 1;
}
