// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { closePageBar } from '../../kit/bar/page-bar';
import { showLanguage } from '../../kit/i18n';
import { keepOffline } from './keep-offline';
import { startOffline } from './start';
import { versionLock } from './versions';

const ENTRY = 'https://school.example/assets/index-12345678.js';

/** A service worker as pages see it. */
class Worker extends EventTarget {
  readonly heard: unknown[] = [];
  constructor(public state: ServiceWorkerState) {
    super();
  }
  postMessage(message: unknown): void {
    this.heard.push(message);
  }
  become(state: ServiceWorkerState): void {
    this.state = state;
    this.dispatchEvent(new Event('statechange'));
  }
}

/** A browser with service workers; `controller` has served this page. */
function browser(controller: Worker | null = null) {
  const registration = Object.assign(new EventTarget(), {
    installing: null as Worker | null,
    waiting: null as Worker | null,
    update: vi.fn(() => Promise.resolve()),
  });
  const register = vi.fn((_address: URL, _how: RegistrationOptions) => Promise.resolve(registration));
  const workers = Object.assign(new EventTarget(), { controller, register });
  const held: string[] = [];
  const locks = {
    request: (name: string, _how: unknown, got: () => unknown) => {
      held.push(name);
      return Promise.resolve(got());
    },
  };
  vi.stubGlobal('navigator', { serviceWorker: workers, locks, languages: ['de'] });
  /** A new version arrives and is ready. */
  const arrives = async () => {
    const worker = new Worker('installing');
    registration.installing = worker;
    registration.dispatchEvent(new Event('updatefound'));
    worker.become('installed');
    await shown();
    return worker;
  };
  const takesOver = async () => {
    workers.dispatchEvent(new Event('controllerchange'));
    await shown();
  };
  return { registration, register, workers, held, arrives, takesOver };
}
const textOf = (element: Element): string => (element.textContent ?? '').trim();
/** Waits for the parts that load with the first message. */
async function shown(): Promise<void> {
  await vi.dynamicImportSettled();
  await nextTick();
}
const bar = (): string => textOf(document.body);
const press = async (name: string): Promise<void> => {
  const button = [...document.querySelectorAll('button')].find(
    (one) => textOf(one) === name || one.getAttribute('aria-label') === name,
  );
  if (button === undefined) throw new Error(`No button ${name} in ${document.body.innerHTML}`);
  button.click();
  await shown();
};
const NEW = 'Eine neue Version von Parcours ist da.';

let reload: ReturnType<typeof vi.spyOn>;
beforeEach(() => {
  showLanguage('de');
  document.head.innerHTML = `<script type="module" src="${ENTRY}"></script>`; // set so, it is not run
  reload = vi.spyOn(location, 'reload').mockImplementation(() => undefined);
});
afterEach(async () => {
  for (const kind of ['update', 'no-storage'] as const) closePageBar(kind);
  await shown();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

describe('the app on the pupil’s device', () => {
  it('is fetched from beside the page, past every cache of the browser', async () => {
    const { register } = browser();
    await keepOffline();
    const [address, how] = register.mock.calls[0]!;
    expect(String(address)).toBe(new URL('sw.js', document.baseURI).href);
    expect(how).toEqual({ updateViaCache: 'none' });
  });

  it('is held in the version of this page as long as the page lives, and only then tidied up', async () => {
    const controller = new Worker('activated');
    const { held } = browser(controller);
    await keepOffline();
    expect(held).toEqual([versionLock(ENTRY)]);
    expect(controller.heard).toEqual([{ type: 'tidy' }]);
  });

  it('is nothing to speak of where the browser has no service workers, or refuses', async () => {
    vi.stubGlobal('navigator', { languages: ['de'] });
    await expect(keepOffline()).resolves.toBeUndefined();
    const { register } = browser();
    register.mockRejectedValue(new Error('private window'));
    await expect(keepOffline()).resolves.toBeUndefined();
    expect(bar()).toBe('');
  });

  it('is kept by a frame only where its host asks for it', async () => {
    const { register } = browser();
    vi.stubGlobal('top', {});
    await keepOffline();
    expect(register).not.toHaveBeenCalled();
    history.replaceState(null, '', '/?flag=sw');
    await keepOffline();
    history.replaceState(null, '', '/');
    expect(register).toHaveBeenCalledOnce();
  });
});

describe('a new version', () => {
  it('is not offered on the first visit, when the app itself arrives', async () => {
    const { arrives, takesOver } = browser();
    await keepOffline();
    await arrives();
    await takesOver();
    expect(bar()).not.toContain(NEW);
    expect(reload).not.toHaveBeenCalled();
  });

  it('is offered when it is there, and waits: no page is ever reloaded by itself', async () => {
    const { arrives } = browser(new Worker('activated'));
    await keepOffline();
    const worker = await arrives();
    expect(bar()).toContain(NEW);
    expect(worker.heard).toEqual([]);
    expect(reload).not.toHaveBeenCalled();
  });

  it('is offered, too, when it was there before the page was opened', async () => {
    const { registration } = browser(new Worker('activated'));
    registration.waiting = new Worker('installed');
    await keepOffline();
    await shown();
    expect(bar()).toContain(NEW);
  });

  it('takes over when the pupil wants it; then the page is loaded anew', async () => {
    const { arrives, takesOver } = browser(new Worker('activated'));
    await keepOffline();
    const worker = await arrives();
    await press('Jetzt neu laden');
    expect(worker.heard).toEqual([{ type: 'take-over' }]);
    expect(reload).not.toHaveBeenCalled();
    await takesOver();
    expect(reload).toHaveBeenCalledOnce();
  });

  it('is left for later: the question goes, and nothing happens', async () => {
    const { arrives } = browser(new Worker('activated'));
    await keepOffline();
    const worker = await arrives();
    await press('Später');
    expect(bar()).not.toContain(NEW);
    expect(worker.heard).toEqual([]);
  });

  it('is offered here if another tab has taken it, and a yes loads the page anew', async () => {
    const { takesOver } = browser(new Worker('activated'));
    await keepOffline();
    await takesOver();
    expect(bar()).toContain(NEW);
    expect(reload).not.toHaveBeenCalled();
    await press('Jetzt neu laden');
    expect(reload).toHaveBeenCalledOnce();
  });

  it('is not offered any more when a still newer one has taken its place', async () => {
    const { arrives } = browser(new Worker('activated'));
    await keepOffline();
    const worker = await arrives();
    worker.become('redundant');
    await shown();
    expect(bar()).not.toContain(NEW);
  });

  it('is looked for when one comes back to the page after an hour, not more often', async () => {
    const { registration } = browser(new Worker('activated'));
    let nowMs = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => nowMs);
    await keepOffline();
    const comesBack = () => document.dispatchEvent(new Event('visibilitychange'));
    nowMs = 3_500_000;
    comesBack();
    expect(registration.update).not.toHaveBeenCalled();
    nowMs = 3_700_000;
    comesBack();
    comesBack();
    expect(registration.update).toHaveBeenCalledOnce();
  });
});

describe('a page that can keep nothing', () => {
  const LOST = 'Hier lässt sich nichts speichern';
  const full = {
    ...{ getItem: () => null, removeItem: () => undefined, clear: () => undefined },
    setItem: () => {
      throw new DOMException('denied', 'SecurityError');
    },
  };
  beforeEach(() => void browser());

  it('says so, once, where the work was to be kept', async () => {
    vi.stubGlobal('localStorage', full);
    await startOffline(true);
    await shown();
    expect(bar()).toContain(LOST);
    await press('Schliessen');
    expect(bar()).not.toContain(LOST);
  });

  it('says nothing where a host keeps the work, or where everything can be kept', async () => {
    await startOffline(true);
    vi.stubGlobal('localStorage', full);
    await startOffline(false);
    await shown();
    expect(bar()).not.toContain(LOST);
  });

  it('leaves nothing of its trial behind', async () => {
    await startOffline(true);
    expect([localStorage.length, sessionStorage.length]).toEqual([0, 0]);
  });
});
