import { adviceOfRun } from '#advice/of-run';
import type { Language } from '#core/languages';
import type { DeviceSetup } from '#simulation/run-setup';
import type { Report } from './report';

/** The report with advice on the errors of its programs, in the words of the page's console and of `check`. */
export function withAdvice(report: Report, devices: readonly DeviceSetup[], language: Language): Report {
  const withAdvice = <T extends Pick<Report, 'exception'>>(of: T, place: number): T => {
    const { exception } = of;
    const advice = exception && adviceOfRun(exception, devices[place]?.files ?? {});
    return exception && advice ? { ...of, exception: { ...exception, advice: advice[language] } } : of;
  };
  return { ...withAdvice(report, 0), devices: report.devices.map(withAdvice) };
}
