import { describe, expect, it } from 'vitest';
import { frameCheckParts, scriptHash, withFrameCheck } from './frame-check.mjs';
import { inlineComment, inlineScript, inlineStyle, singleFile } from './single-file.mjs';

const PAGE = `<!doctype html>
<html lang="de">
  <head>
    <meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'" />
    <link rel="icon" type="image/svg+xml" href="./logo.svg" />
    <title>Parcours</title>
    <script type="module" src="./main.ts"></script>
  </head>
  <body>
    <div id="app"></div>
  </body>
</html>
`;
const check = await frameCheckParts();
const single = (script) => singleFile(PAGE, { script, css: 'p{}', icon: '<svg/>', licences: 'MIT', check });

/** The scripts inside a page: the check, and the app where it is a single file. */
const scriptsIn = (page) => Array.from(page.matchAll(/<script>([^]*?)<\/script>/g), ([, script]) => script);

describe('code inside a page', () => {
  it('cannot end its element, nor hide its end', () => {
    const text = 'a</script><!--<script></SCRIPT>';
    const code = inlineScript(`result = ${JSON.stringify(text)}`);
    expect(code).not.toMatch(/<\/script|<script|<!--/i);
    expect(new Function('let result; return ' + code)()).toBe(text);
  });

  it('cannot close a style element either', () => {
    expect(inlineStyle('a::after{content:"</style>"}')).not.toContain('</style');
  });
});

describe('a text in a comment', () => {
  it('cannot end it', () => {
    const inside = inlineComment(`one --> two --!> three ${'-'.repeat(80)}`);
    expect(inside).not.toMatch(/--!?>/);
    expect(inside).toContain('-'.repeat(80));
  });
});

describe('the single file', () => {
  it('carries the licences of its parts, behind the page', () => {
    expect(single('run()')).toMatch(/<\/html>\n<!--\nMIT\n-->\n$/);
  });

  it('asks for no other file', () => {
    expect(single('run()')).not.toMatch(/(src|href)="(?!data:)/);
  });

  it('allows its own script alone, by its hash', () => {
    const page = single('run("$&")');
    const [first, script] = scriptsIn(page);
    expect(first).toBe(check.script);
    expect(script.trim()).toBe('run("$&")');
    expect(page).toContain(`script-src ${scriptHash(script)} 'wasm-unsafe-eval'`);
    expect(page).toContain("connect-src 'none'");
  });

  it('runs its script when the page is there', () => {
    const page = single('run()');
    expect(page.lastIndexOf('<script>')).toBeGreaterThan(page.indexOf('id="app"'));
  });

  it('is not made of a page that looks otherwise', () => {
    expect(() => singleFile('<p>', { script: '', css: '', icon: '', licences: '', check })).toThrow(/nothing like/);
  });
});

/** A browser as the check sees it, and what it does there. */
function checked({
  list = { at() {}, toReversed() {} },
  at = 'https://school.example/',
  agent = 'Chrome/120',
  ...more
}) {
  const page = { attributes: {}, listeners: {}, policy: '' };
  const root = {
    hasAttribute: (name) => name in page.attributes || (name === 'data-single' && more.isSingle === true),
    setAttribute: (name, value) => (page.attributes[name] = value),
  };
  const wish = {
    content: "script-src 'self' 'wasm-unsafe-eval'",
    parentNode: { replaceChild: (it) => (page.policy = it) },
  };
  const document = {
    documentElement: root,
    querySelector: () => wish,
    createElement: () => (more.hasModules === false ? {} : { noModule: false }),
  };
  const { search, protocol } = new URL(at);
  const names = ['document', 'location', 'navigator', 'self', 'addEventListener'];
  const navigator = { userAgent: agent, languages: more.languages ?? ['en-GB'] };
  const listen = (name, listener) => (page.listeners[name] = listener);
  const self = { origin: more.origin ?? 'https://school.example' };
  const script = check.script.replaceAll('[].', 'list.');
  new Function(...names, 'list', script)(document, { search, protocol }, navigator, self, listen, list);
  return { ...page, why: page.attributes['data-cannot'] ?? null, said: page.attributes['data-said'] };
}

describe('why a page cannot start', () => {
  it('is said in each of the four languages', () => {
    const reasons = check.html.split(/<(?:div|noscript)/).slice(2);
    expect(reasons).toHaveLength(5);
    for (const reason of reasons)
      expect(Array.from(reason.matchAll(/<p lang="(\w\w)">/g), ([, it]) => it)).toEqual(['de', 'fr', 'it', 'en']);
  });

  it('is nothing at first in a browser that will do', () => {
    expect(checked({}).why).toBeNull();
    expect(checked({ agent: 'Firefox/115.0' }).why).toBeNull();
  });

  it('is the browser, where it is older than the oldest', () => {
    expect(checked({ list: {} }).why).toBe('old');
    expect(checked({ hasModules: false }).why).toBe('old');
    expect(checked({ agent: 'Firefox/114.0' }).why).toBe('old');
  });

  it('is the frame, or the folder that it was opened from', () => {
    expect(checked({ origin: 'null' }).why).toBe('frame');
    expect(checked({ origin: 'null', at: 'file:///C:/index.html' }).why).toBe('folder');
    expect(checked({ origin: 'null', isSingle: true }).why).toBeNull();
  });

  it.each(['error', 'unhandledrejection'])('is a file that does not come, after an event %s', (event) => {
    const page = checked({});
    page.listeners[event]({ target: {} });
    expect(page.attributes['data-cannot']).toBe('files');
  });

  it('keeps to the first reason', () => {
    const page = checked({ list: {} });
    page.listeners.error({ target: {} });
    expect(page.attributes['data-cannot']).toBe('old');
  });

  it('is not a preload: the script itself may still come', () => {
    const page = checked({});
    page.listeners.error({ target: { rel: 'modulepreload' } });
    expect(page.attributes).not.toHaveProperty('data-cannot');
  });

  it('is told in the language of the address, or else in the first that the browser wants', () => {
    expect(checked({ at: 'https://school.example/?lang=it' }).said).toBe('it');
    expect(checked({ languages: ['ja', 'fr-CH', 'de'] }).said).toBe('fr');
    expect(checked({ languages: ['ja'] }).said).toBe('de');
  });

  it('can be read by any browser: the script has nothing newer than ES5', () => {
    expect(check.script).not.toMatch(/=>|`|\b(const|let|class)\b|\?[.?]/);
  });
});

describe('the page’s own policy', () => {
  it('is set by the check, whose script the host’s policy allows by its hash', () => {
    const page = withFrameCheck(PAGE, check);
    expect(page).toContain(`<script>${check.script}</script>`);
    expect(page).toMatch(
      /<meta name="policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'" \/>\s*<script>/,
    );
    expect(page).toContain('<div id="app"><div class="cannot-start"');
    expect(checked({}).policy).toMatchObject({
      httpEquiv: 'Content-Security-Policy',
      content: "script-src 'self' 'wasm-unsafe-eval'",
    });
  });

  it('lets the VM start also in browsers that do not know the word for that', () => {
    expect(checked({ list: { at() {} } }).policy.content).toBe("script-src 'self' 'unsafe-eval'");
  });

  it('stands in the single file too, which has no sentence about frames', () => {
    expect(single('run()')).toContain('<html data-single lang="de">');
    expect(single('run()')).not.toContain('parcours.single.html');
    expect(single('run()')).toContain('<div class="old">');
  });
});
