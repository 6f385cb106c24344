import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { isThere, openApp } from './page';
import { by, gone, until } from './parts';

test(
  'a photograph larger than any screen is dropped, cut by keyboard and becomes the floor; one step takes it back',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'de', welcomed: true });
    await app.evaluate(async () => {
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [4000, 3000];
      const context = canvas.getContext('2d');
      if (context === null) throw new Error('There is no canvas.');
      context.fillStyle = '#ddd';
      context.fillRect(0, 0, 4000, 3000);
      context.fillStyle = '#222';
      context.fillRect(1900, 0, 200, 3000);
      const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/jpeg', 0.8));
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(blob === null ? [] : [blob], 'IMG_0001.JPG', { type: 'image/jpeg' }));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }, null);
    await until(app, by('photo-floor'));
    const label = (css: string): Promise<string> =>
      app.evaluate((at) => document.querySelector(at)?.getAttribute('aria-label') ?? '', css);
    await app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), by('corner-0'));
    await app.press('ArrowRight');
    expect(await label(by('corner-0'))).toBe('Ecke oben links: 1 | 0 %');
    await app.click(by('take-floor'));
    await gone(app, by('photo-floor'));
    await until(app, by('undo'));
    await app.click(by('undo'));
    await expect.poll(() => isThere(app, `${by('undo')}:disabled`)).toBe(true);
  },
);
