/** A name that a learning platform has given to what a pupil has handed in. */
interface PlatformName {
  /** All that the platform has put before the name of a file. */
  readonly before: string;
  readonly pupil: string;
  /** The name of the file; empty for a folder. */
  readonly file: string;
}

/** Moodle's names: “Weiss Tim_10231_assignsubmission_file_” with the name of the file, if it is one. */
const MOODLE = /^((.+?)_\d+_assignsubmission_(?:file|onlinetext)_)(.*)$/;

/** Parts a name that a learning platform has given; `null`: it is another one. */
export function platformName(name: string): PlatformName | null {
  const [, before, pupil, file] = MOODLE.exec(name) ?? [];
  return before === undefined || pupil === undefined ? null : { before, pupil, file: file ?? '' };
}
