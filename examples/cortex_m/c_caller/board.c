/* A Cortex-M with a floating-point unit, from reset to main and back to the host.
 *
 * In: the addresses of link.ld. Out: a call of main, whose 0 becomes the status 0 of QEMU. */

#include <stdint.h>

#include "board.h"

enum { SYS_OPEN = 0x01, SYS_WRITE = 0x05, SYS_EXIT = 0x18 };
enum { RUN_TIME_ERROR = 0x20023, APPLICATION_EXIT = 0x20026 };

extern uint32_t stack_top, data_start, data_end, data_source, bss_start, bss_end;

int main(void);
void reset(void); /* link.ld names it */

/* The host's standard output. */
static uint32_t output;

static uint32_t ask_host(uint32_t what, uintptr_t with)
{
    register uint32_t r0 __asm__("r0") = what;
    register uintptr_t r1 __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void open_output(void)
{
    const uintptr_t arguments[] = {(uintptr_t)":tt", 4 /* for writing */, 3 /* its length */};
    output = ask_host(SYS_OPEN, (uintptr_t)arguments);
}

void print(const char *text)
{
    uintptr_t length = 0;
    while (text[length] != 0)
        length++;
    const uintptr_t arguments[] = {output, (uintptr_t)text, length};
    ask_host(SYS_WRITE, (uintptr_t)arguments);
}

static void leave(uint32_t reason)
{
    ask_host(SYS_EXIT, reason);
    for (;;)
        ;
}

static void fault(void)
{
    leave(RUN_TIME_ERROR);
}

void reset(void)
{
    volatile uint32_t *const cpacr = (volatile uint32_t *)0xe000ed88;
    *cpacr |= 0xfu << 20; /* floating point for all */
    __asm__ volatile("dsb\n isb");
    for (uint32_t *to = &data_start, *from = &data_source; to < &data_end;)
        *to++ = *from++;
    for (uint32_t *to = &bss_start; to < &bss_end;)
        *to++ = 0;
    open_output();
    leave(main() == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
}

/* The initial stack pointer, reset, and the faults; no interrupt is turned on. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*handlers[15])(void);
} vectors = {&stack_top, {reset, fault, fault, fault, fault, fault}};
