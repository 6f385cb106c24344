import { collected, type HelpEntry } from '../../kit/features/feature';

/** The features' entries of the help: each has a `help-entries.ts`. Loaded on demand. */
export const allHelpEntries: readonly HelpEntry[] = collected(
  import.meta.glob<readonly HelpEntry[]>('../../**/help-entries.ts', { eager: true, import: 'helpEntries' }),
).flat();
