(() => {
  const { documentElement: root } = document;
  const wanted = [new URLSearchParams(location.search).get('lang'), ...navigator.languages];
  root.dataset.said = wanted.map((tag) => tag?.slice(0, 2)).find((it) => /^(de|fr|it|en)$/.test(it)) ?? 'de';
  root.dataset.opaque = String(self.origin === 'null');
})();
