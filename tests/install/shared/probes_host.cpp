extern "C" int countProbes();

int main() {
  return countProbes() == 1 ? 0 : 1;
}
