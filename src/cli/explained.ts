import type { AtTable } from '#advice/at-table';
import { adviceOfRun } from '#advice/of-run';
import { findBoard } from '#board/boards/index';
import type { Language } from '#core/languages';
import { importsOf } from '#python/imports';
import { findRobot } from '#robots/index';
import { robotFault } from '#simulation/robot-fit';
import type { DeviceSetup } from '#simulation/run-setup';
import type { Report } from './report';

/** The report with advice on the errors of its programs, in the words of the page's console and of `check`. */
export function withAdvice(report: Report, devices: readonly DeviceSetup[], language: Language): Report {
  const withAdvice = <T extends Pick<Report, 'exception'>>(of: T, place: number): T => {
    const { exception } = of;
    const device = devices[place];
    const advice = exception && adviceOfRun(exception, device?.files ?? {}, device && atTable(device));
    return exception && advice ? { ...of, exception: { ...exception, advice: advice[language] } } : of;
  };
  return { ...withAdvice(report, 0), devices: report.devices.map(withAdvice) };
}

/** The robot of a device, as far as it can cause an error. */
function atTable({ board: id, robot: chosen, files }: DeviceSetup): AtTable | null {
  const board = findBoard(id);
  if (board === undefined) return null;
  const robot = findRobot(chosen);
  const fault = robotFault({ board, robot }, importsOf(files));
  return { robot: robot?.name ?? null, fault: fault && { key: `error.${fault.kind}`, values: fault.values } };
}
