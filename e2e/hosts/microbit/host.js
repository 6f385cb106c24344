// A page around micro:bit simulators that behaves as the simulator device of the official Python editor does
// (python-editor-v3, src/device/simulator.ts): it brings its files when asked for them, keeps the state by merging changes,
// gathers what is printed, sent and logged. With several frames it carries radio packets between them, as swarm pages do.
'use strict';

/** Prefix that every simulator puts before the text of `radio.send`. */
const TEXT_PACKET = [1, 0, 1];

class Simulator {
  constructor(address) {
    this.status = 'disconnected';
    this.state = {};
    this.serial = '';
    this.radio = [];
    this.log = { headings: [], rows: [] };
    this.errors = [];
    this.kinds = [];
    this.files = { 'main.py': '' };
    this.peers = [];
    this.iframe = document.createElement('iframe');
    this.iframe.name = 'Simulator';
    this.iframe.title = 'Simulator';
    this.iframe.allow = 'autoplay;microphone';
    this.iframe.sandbox = 'allow-scripts allow-same-origin';
    this.iframe.scrolling = 'no';
    this.iframe.frameBorder = 'no';
    this.iframe.src = address;
    // Lessons that show the frame only when its program is wanted.
    if (new URLSearchParams(location.search).has('hidden')) this.iframe.style.display = 'none';
    window.addEventListener('message', (event) => {
      if (event.source !== this.iframe.contentWindow || !event.data.kind) return;
      this.kinds.push(event.data.kind);
      this.hear(event.data);
    });
    document.body.append(this.iframe);
  }

  hear(message) {
    switch (message.kind) {
      case 'ready':
        this.state = message.state;
        this.status = 'connected';
        break;
      case 'request_flash':
        this.flash();
        break;
      case 'state_change':
        this.state = { ...this.state, ...message.change };
        break;
      case 'serial_output':
        this.serial += message.data;
        break;
      case 'radio_output':
        this.radio.push(new TextDecoder().decode(message.data).replace(/^\x01\x00\x01/, ''));
        for (const peer of this.peers) peer.send({ kind: 'radio_input', data: message.data });
        break;
      case 'log_output':
        if (message.headings) this.log.headings = message.headings;
        if (message.data) this.log.rows.push(message.data);
        break;
      case 'log_delete':
        this.log = { headings: [], rows: [] };
        break;
      case 'internal_error':
        // Hosts hand it on to what gathers errors, which looks at its class.
        this.errors.push(message.error instanceof Error ? message.error.message : 'unknown error');
        break;
    }
  }

  send(message) {
    this.iframe.contentWindow.postMessage(message, '*');
  }

  flash() {
    const encoder = new TextEncoder();
    const entries = Object.entries(this.files).map(([name, text]) => [name, encoder.encode(text)]);
    this.send({ kind: 'flash', filesystem: Object.fromEntries(entries) });
  }

  sendRadio(text) {
    this.send({ kind: 'radio_input', data: Uint8Array.from([...TEXT_PACKET, ...new TextEncoder().encode(text)]) });
  }

  configure(language, translations) {
    this.send({ kind: 'config', language, translations });
  }
}

window.addEventListener('DOMContentLoaded', () => {
  const asked = new URLSearchParams(location.search);
  const simulators = asked.getAll('simulator').map((address) => new Simulator(address));
  for (const one of simulators) one.peers = simulators.filter((other) => other !== one);
  window.simulators = simulators;
  // The editor says this as soon as it is drawn, mostly before the frame listens.
  for (const one of simulators) one.configure('en', { 'start-simulator': 'Start simulator' });
});
