/**
 * Waits until all pending tasks have run, before a long one: a message is delivered after them, without the delay of a
 * timer.
 */
export function turn(): Promise<void> {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage("");
  });
}
