import { useCourseEditor } from '../../course/editor/state/parts';
import { pickFiles } from '../../kit/files/pick-files';
import { latePart } from '../../kit/late-part';
import { usePage } from '../../kit/parts';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useWork } from '../../session/work/model/parts';
import { saveFile } from '../../session/work/save-file';
import type { TakesFiles } from './load-files';

/** The commands for a component, in `setup`. */
export const useCommands = () =>
  commandsOf({ ...usePage(), ...useRun(), ...useWork(), ...useLayout(), ...useCourseEditor() });

/** The commands that several bars and keys share. */
export function commandsOf(app: TakesFiles) {
  /** Takes files in, from the picker or dropped onto the page. */
  function take(files: Iterable<File>): void {
    const all = [...files]; // a browser empties the list of dropped files at once
    late(import('./load-files'), (loading) => void loading.takeFiles(app, all));
  }

  function load(): void {
    const accept = '.py,.hex,.json,.zip,.htm,.html,.csv,.tsv,.txt,.png,.jpg,.jpeg,.svg,text/x-python,application/json';
    pickFiles({ accept, multiple: true }, take);
  }

  /** Does something with a part of the page once that is loaded; a message says if it cannot be. */
  function late<T>(part: Promise<T>, act: (part: T) => void): void {
    part.then(act).catch(() => app.notices.show(latePart));
  }

  return {
    take,
    load,
    /** Saves everything as one file. */
    save: (): void => late(import('../../session/work/save-work'), ({ saveProject }) => saveProject(app)),
    saveScene: (): void => late(import('../../session/work/save-work'), ({ saveScene }) => saveScene(app)),
    /** Saves the file that is shown. */
    saveProgram: (): void => saveFile(app, app.work.open.value),
  };
}
