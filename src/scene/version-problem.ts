import { shown, type SceneProblem } from './problem';

/**
 * The problem of a file of a version that this app does not read.
 *
 * @param what name of the file in the message: `Project`, `Series`
 * @param known the newest version that is read
 */
export function versionProblem(
  what: string,
  version: unknown,
  known: number,
): SceneProblem & { readonly code: 'newer-version' | 'unknown-version' } {
  const isNewer = typeof version === 'number' && Number.isInteger(version) && version > known;
  const params = { version: typeof version === 'number' ? version : shown(version).slice(0, 20), known };
  const message = isNewer
    ? `${what} version ${String(version)} is newer than this app (${String(known)}). Reload the page to update.`
    : `${what} version ${String(params.version)} is unknown; this app reads version ${String(known)}.`;
  return {
    code: isNewer ? 'newer-version' : 'unknown-version',
    path: 'version',
    value: shown(version),
    params,
    message,
  };
}
