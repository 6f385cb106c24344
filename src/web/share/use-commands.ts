import type * as SaveWork from './save-work';
import { THEMES } from '../work/settings/settings';
import type { Workplace } from '../work/model/parts';
import { saveFile } from '../work/save-file';
import { loadBeside, loadFiles, replaceFile } from './load-files';

/** The commands that several bars and keys share. */
export function useCommands(app: Workplace) {
  /** Takes files in, from the picker or dropped onto the page. */
  function take(files: Iterable<File>): void {
    void loadFiles(app, files, ({ file, as }) =>
      app.dialogs.ask({
        kind: 'choose',
        title: 'files.askTitle',
        text: 'files.askText',
        values: { file: file.name },
        choices: [
          { key: 'code.cancel', run: () => undefined },
          { key: 'files.askReplace', look: 'outline', run: () => replaceFile(app, file) },
          { key: 'files.askRename', values: { as }, look: 'run', run: () => loadBeside(app, file) },
        ],
      }),
    );
  }

  function load(): void {
    const picker = document.createElement('input');
    picker.type = 'file';
    picker.accept = '.py,.json,text/x-python,application/json';
    picker.multiple = true;
    picker.addEventListener('change', () => take(picker.files ?? []));
    picker.click();
  }

  /** Saving other files than programs comes late. */
  function late(act: (saving: typeof SaveWork) => void): void {
    import('./save-work').then(act).catch(() => app.notices.show({ kind: 'error', key: 'notice.firmware' }));
  }

  return {
    take,
    load,
    /** Everything as one file. */
    save: (): void => late(({ saveProject }) => saveProject(app)),
    saveScene: (): void => late(({ saveScene }) => saveScene(app)),
    /** The file that is shown. */
    saveProgram: (): void => saveFile(app, app.work.open.value),
    /** Sound on or off, and in words what that means. */
    switchSound: (): void => {
      const muted = !app.settings.current.value.muted;
      app.settings.change({ muted });
      app.notices.show({ kind: 'info', key: muted ? 'notice.muted' : 'notice.unmuted' });
    },
    /** Switches between light and dark. */
    switchTheme: (): void => {
      const dark = document.documentElement.dataset['theme'] === 'dark';
      app.settings.change({ theme: dark ? 'light' : 'dark' });
    },
    themes: THEMES,
  };
}
