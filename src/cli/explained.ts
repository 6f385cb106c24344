import { adviceOfRun } from '#advice/of-run';
import type { Language } from '#core/languages';
import type { DeviceSetup } from '#simulation/run-setup';
import type { Report } from './report';

/** The report with what the errors of its programs mean, as the console of the page and `check` say it. */
export function explained(report: Report, devices: readonly DeviceSetup[], language: Language): Report {
  const withAdvice = <T extends Pick<Report, 'exception'>>(of: T, place: number): T => {
    const { exception } = of;
    const advice = exception && adviceOfRun(exception, devices[place]?.files ?? {});
    return exception && advice ? { ...of, exception: { ...exception, advice: advice[language] } } : of;
  };
  return { ...withAdvice(report, 0), devices: report.devices.map(withAdvice) };
}
