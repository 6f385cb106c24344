import type { EntryId, SectionId, STEP_IDS } from './entry-ids';

/** Entries whose name stands nowhere else in the app. */
export type OwnName =
  | (typeof STEP_IDS)[number]
  | 'sound'
  | 'stages'
  | 'tour'
  | 'help'
  | 'real-device'
  | 'files'
  | 'suggestions'
  | 'explain'
  | 'buttons'
  | 'arena-hand'
  | 'readings'
  | 'zoom'
  | 'fullscreen'
  | 'verdict'
  | 'input';

/** The words of the help in one language. A language that misses one does not compile. */
export interface GuideContent {
  readonly title: string;
  readonly close: string;
  readonly search: string;
  readonly searchHint: string;
  readonly emptySearch: string;
  /** `{count}` entries were found. */
  readonly found: string;
  readonly foundOne: string;
  readonly foundNone: string;
  /** What to do instead where nothing was found. */
  readonly foundNoneHint: string;
  /** A fold with the commands of a module: `{module}`. */
  readonly commands: string;
  readonly commandsHint: string;
  /** Name of the button that writes `{code}` into the program. */
  readonly insert: string;
  readonly inserted: string;
  readonly insertFailed: string;
  readonly startTour: string;
  readonly resumeTour: string;
  readonly sections: Readonly<Record<SectionId, string>>;
  readonly names: Readonly<Record<OwnName, string>>;
  readonly texts: Readonly<Record<EntryId, string>>;
}
