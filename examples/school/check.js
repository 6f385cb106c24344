// The page check.html: shows what is right and wrong with the server that it comes from, in the browser's language.
import { askForAll, findingsIn } from './judge.js';
import { texts } from './texts.js';

const language = [...navigator.languages].map((tag) => tag.slice(0, 2)).find((tag) => tag in texts) ?? 'en';
const words = texts[language];
const main = document.getElementById('main');

const element = (name, text = '', sign = '') =>
  Object.assign(document.createElement(name), { textContent: text, className: sign });

/** Past the browser's caches, and past the service worker, which knows no such address. */
const ask = (file) => fetch(`${file}?check=${Date.now()}`, { cache: 'no-store' });

/** The findings that only a browser can make. */
async function findingsHere() {
  const isSecure = globalThis.isSecureContext;
  const worker = async () => {
    if (!isSecure || !('serviceWorker' in navigator)) return 'warn';
    return navigator.serviceWorker.register('sw.js').then(
      () => 'ok',
      () => 'bad',
    );
  };
  return [
    { id: 'https', state: isSecure ? 'ok' : 'warn', files: [] },
    { id: 'offline', state: await worker(), files: [] },
  ];
}

function shown({ id, state, files }) {
  const { right, wrong, mend } = words.findings[id];
  const item = element('li', '', state);
  item.dataset.testid = `check-${id}`;
  item.append(element('b', state === 'ok' ? right : wrong));
  if (state === 'ok') return item;
  if (files.length > 0) item.append(element('p', files.join(', ')));
  item.append(element('p', mend));
  return item;
}

async function check() {
  document.documentElement.lang = language;
  document.title = `Parcours: ${words.title}`;
  const sum = element('p', words.asking, 'sum');
  sum.setAttribute('role', 'status');
  sum.dataset.testid = 'check-sum';
  const found = element('ul');
  main.replaceChildren(element('h1', words.title), sum, found);
  const listed = await ask('files.json').then(
    (response) => response.json(),
    () => null,
  );
  if (listed === null) {
    sum.textContent = words.noList;
    return;
  }
  const count = listed.files.length;
  const answers = await askForAll(listed, ask, (done) => {
    sum.textContent = `${words.asking} ${done} / ${count}`;
  });
  const findings = [...(await findingsHere()), ...findingsIn(answers, listed.policies)];
  const order = ['bad', 'warn', 'ok'];
  findings.sort((one, other) => order.indexOf(one.state) - order.indexOf(other.state));
  found.replaceChildren(...findings.map(shown));
  const worst = findings[0]?.state ?? 'ok';
  sum.textContent = words.sum[worst];
  sum.dataset.state = worst;
  const way = Object.assign(element('a', words.toPage), { href: './' });
  const last = element('p');
  last.append(way);
  main.append(last);
}

void check();
