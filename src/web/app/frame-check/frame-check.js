// Read by the oldest of browsers: in the language of 2009.
(function () {
  var root = document.documentElement;
  var isSingle = root.hasAttribute('data-single');
  var wanted = [(/[?&]lang=(..)/.exec(location.search) || [])[1]].concat(navigator.languages || navigator.language);
  var said = 'de';
  for (var at = wanted.length - 1; at >= 0; at--) {
    var tag = String(wanted[at]).slice(0, 2);
    if (/^(de|fr|it|en)$/.test(tag)) said = tag;
  }
  root.setAttribute('data-said', said);

  // The page's policy. What has no `toReversed` need not know 'wasm-unsafe-eval': there the wider word lets the VM start.
  var policy = document.createElement('meta');
  var wish = document.querySelector('meta[name="policy"]');
  policy.httpEquiv = 'Content-Security-Policy';
  policy.content = [].toReversed ? wish.content : wish.content.replace("'wasm-unsafe-eval'", "'unsafe-eval'");
  wish.parentNode.replaceChild(policy, wish);

  function cannotStart(why) {
    if (!root.hasAttribute('data-cannot')) root.setAttribute('data-cannot', why);
  }
  var firefox = /Firefox\/(\d+)/.exec(navigator.userAgent);
  var isOld = !('noModule' in document.createElement('script')) || ![].at || (firefox && firefox[1] < 115);
  if (isOld) cannotStart('old');
  else if (!isSingle && self.origin === 'null') cannotStart(location.protocol === 'file:' ? 'folder' : 'frame');
  // What fails before the app has taken the sentence's place: a file that does not come, or comes as something else.
  // A preload may fail in Firefox while the script itself comes.
  function failed(event) {
    if (event.target.rel !== 'modulepreload') cannotStart('files');
  }
  addEventListener('error', failed, true);
  addEventListener('unhandledrejection', failed);
})();
