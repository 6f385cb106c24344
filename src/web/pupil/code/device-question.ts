import type { Stop } from '#core/stop';
import type { Device } from '#device-check/finding';
import type { Language } from '../../kit/i18n';
import type { Written } from '../../session/work/hardware/written-for';

/** Everything besides its text that the check of the shown file depends on. */
export interface DeviceQuestion {
  readonly file: string;
  /** The other files of the project, by name: names that they define are not mistakes. */
  readonly files: Readonly<Record<string, string>>;
  readonly device: Device;
  /** Name of the microcomputer. */
  readonly board: string;
  readonly language: Language;
  /** The file among all, and what it is written for: what its names mean. */
  readonly written: () => Written;
}

/** The sources of the marks. */
export interface DeviceMarksOptions {
  /** Asked at every check; `null`: there is nothing to check against, no marks. */
  readonly question: () => DeviceQuestion | null;
  /** True if the program is one of ours just as it came, for its own board: there is nothing to find in it. */
  readonly isOurs: () => boolean;
  /**
   * Calls the listener when the question has changed: another board or firmware, or the check is switched on or off.
   */
  readonly onChange: (listener: () => void) => Stop;
}
