import { firmwareText } from '../src/hex/testing/firmware';
import type { App } from './app';

/** A file that the page has handed to the browser to be saved. */
export interface SavedFile {
  readonly name: string;
  readonly text: string;
}

interface WithSaved {
  saved?: Promise<SavedFile>[];
}

/** Notes from now on what the page saves, in place of the browsers' own downloads, which differ. */
export const watchSaving = (app: App): Promise<void> =>
  app.evaluate(() => {
    const saved: Promise<SavedFile>[] = ((window as WithSaved).saved = []);
    const blobs = new Map<string, Blob>();
    const create = URL.createObjectURL.bind(URL);
    URL.createObjectURL = (object: Blob | MediaSource) => {
      const url = create(object);
      if (object instanceof Blob) blobs.set(url, object);
      return url;
    };
    HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
      const blob = blobs.get(this.href);
      if (this.download === '' || blob === undefined) this.dispatchEvent(new MouseEvent('click', { cancelable: true }));
      else saved.push(blob.text().then((text) => ({ name: this.download, text })));
    };
  });

/** The files saved since `watchSaving`, the oldest first. */
export const savedFiles = (app: App): Promise<SavedFile[]> =>
  app.evaluate(() => Promise.all((window as WithSaved).saved ?? []));

/** Drops a file onto the page, as out of a folder. */
export const dropFile = (app: App, file: SavedFile): Promise<void> =>
  app.evaluate(({ name, text }) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    for (const type of ['dragenter', 'dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
  }, file);

/** Whenever the page asks for a file from now on, this one is chosen: the browsers' own windows for it are no part of the page. */
export const pickFile = (app: App, file: SavedFile): Promise<void> =>
  app.evaluate(({ name, text }) => {
    HTMLInputElement.prototype.click = function (this: HTMLInputElement) {
      if (this.type !== 'file') {
        this.dispatchEvent(new MouseEvent('click', { bubbles: true, cancelable: true }));
        return;
      }
      const chosen = new DataTransfer();
      chosen.items.add(new File([text], name));
      this.files = chosen.files;
      this.dispatchEvent(new Event('change', { bubbles: true }));
    };
  }, file);

/** Gives the dialog for real boards MicroPython for the micro:bit V2, where it asks for it. */
export const giveFirmware = (app: App): Promise<void> =>
  app.evaluate((text) => {
    const field = document.querySelector<HTMLInputElement>('[data-testid="firmware-file"]');
    if (field === null) return;
    const files = new DataTransfer();
    files.items.add(new File([text], 'mine.hex'));
    field.files = files.files;
    field.dispatchEvent(new Event('change'));
  }, firmwareText('microbit-v2'));
