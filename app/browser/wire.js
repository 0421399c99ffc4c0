// The connection to the live service: requests with their answers, and what comes by itself.

/** What the service refuses, with its own sentences. */
export class Refused extends Error {
  constructor(problems) {
    super(problems.map((problem) => problem.sentence).join(" "));
    this.problems = problems;
  }
}

/** One connection. onTicks(columns), onEvent(event), onClose(sentence): called as they come. */
export class Wire {
  constructor(calls) {
    this.calls = calls;
    this.socket = null;
    this.waiting = new Map();
    this.number = 0;
  }

  get isOpen() {
    return this.socket !== null && this.socket.readyState === WebSocket.OPEN;
  }

  /** Says hello; what the service says of itself. Fails with a sentence for people. */
  connect(address, token, name) {
    return new Promise((resolve, reject) => {
      let socket;
      try {
        socket = new WebSocket(address);
      } catch {
        reject(new Error(`“${address}” is not an address. It looks like ws://127.0.0.1:7171.`));
        return;
      }
      this.socket = socket;
      let greeted = false;
      socket.onopen = () => {
        this.ask("hello", { token, name }).then(
          (about) => {
            greeted = true;
            resolve(about);
          },
          (error) => {
            reject(error);
            this.close();
          },
        );
      };
      socket.onmessage = (message) => this.take(JSON.parse(message.data));
      socket.onclose = () => {
        for (const { reject: fail } of this.waiting.values()) fail(new Error("The connection has ended."));
        this.waiting.clear();
        if (this.socket !== socket) return;
        this.socket = null;
        if (greeted) this.calls.onClose("The connection has ended. What this page steered has ended with it.");
        else
          reject(
            new Error(
              `Nothing answers at ${address}, or it does not let this page in. The service needs ` +
                `--allow-origin ${location.origin === "null" || location.protocol === "file:" ? "null" : location.origin}.`,
            ),
          );
      };
    });
  }

  /** The answer to a request; fails with Refused where it is refused. */
  ask(what, keys = {}) {
    if (!this.isOpen) return Promise.reject(new Error("There is no connection."));
    const id = ++this.number;
    this.socket.send(JSON.stringify({ id, do: what, ...keys }));
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  close() {
    if (this.socket !== null) this.socket.close();
  }

  take(message) {
    if (message.ticks) this.calls.onTicks(message.ticks);
    else if (message.event) this.calls.onEvent(message);
    else if (this.waiting.has(message.id)) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (message.ok) resolve(message);
      else reject(new Refused(message.problems));
    }
  }
}
