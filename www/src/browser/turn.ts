/** Lets all that waits have its turn before something that takes long: a message comes after what is due, and waits for no clock. */
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
