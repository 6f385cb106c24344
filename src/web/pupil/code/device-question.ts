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

/** How the marks learn what they are about. */
export interface DeviceMarksOptions {
  /** Asked at every check; `null`: there is nothing to check against, no marks. */
  readonly question: () => DeviceQuestion | null;
  /** True if the program is one of ours just as it came, for its own board: there is nothing to find in it. */
  readonly isOurs: () => boolean;
  /** Tells when the question has changed, for another board or another file of the project. */
  readonly onChange: (listener: () => void) => Stop;
}
